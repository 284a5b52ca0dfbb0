set(TEST_UQ_ANALYSIS_SOURCES
    uq/test_analysis_stub.cpp)
