set(TEST_UQ_SAMPLING_SOURCES
    uq/test_stream.cpp)
