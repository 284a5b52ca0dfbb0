# Statistics of limit displacements and modes: needs drystone_fragility alone, so that it builds fast.
drystone_tests(fragility_fits
    SOURCES
        fragility/test_binomial.cpp
        fragility/test_censored_fit.cpp
        fragility/test_fit_intervals.cpp
        fragility/test_fragility_curve.cpp
        fragility/test_goodness_of_fit.cpp
        fragility/test_kaplan_meier.cpp
        fragility/test_lower_bound.cpp
        fragility/test_mode_model.cpp
        fragility/test_standard_law.cpp
        fragility/test_stress_model.cpp
        fragility/test_stripe_fit.cpp
    LIBRARIES drystone_fragility)
