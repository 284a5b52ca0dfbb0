set(TEST_UQ_SURROGATE_SOURCES
    uq/surrogates/test_bounded_normal.cpp
    uq/surrogates/test_calibration.cpp
    uq/surrogates/test_gaussian_process.cpp
    uq/surrogates/test_given_data.cpp
    uq/surrogates/test_inference.cpp
    uq/surrogates/test_polynomial_chaos.cpp)
