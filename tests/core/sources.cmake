drystone_tests(core
    SOURCES
        core/test_binomial.cpp
        core/test_eigen_pairs.cpp
        core/test_fit_factors.cpp
        core/test_gauss_legendre.cpp
        core/test_matrix_factors.cpp
        core/test_moments.cpp
        core/test_normal.cpp
        core/test_sample_quantile.cpp
    LIBRARIES drystone_core drystone_core_factors drystone_core_matrices drystone_uq_sampling)
