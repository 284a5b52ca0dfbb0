set(TEST_UQ_SAMPLING_SOURCES
    uq/test_marginal.cpp
    uq/test_stream.cpp)
