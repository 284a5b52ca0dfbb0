set(UQ_ANALYSIS_SOURCES
    analysis_stub.cpp)
