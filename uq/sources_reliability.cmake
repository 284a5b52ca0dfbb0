set(UQ_RELIABILITY_SOURCES
    reliability_stub.cpp)
