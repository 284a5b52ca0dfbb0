set(TEST_UQ_RELIABILITY_SOURCES
    uq/test_reliability_stub.cpp)
