set(TEST_UQ_SURROGATE_SOURCES
    uq/test_calibration.cpp
    uq/test_gaussian_process.cpp
    uq/test_given_data.cpp
    uq/test_inference.cpp
    uq/test_polynomial_chaos.cpp)
