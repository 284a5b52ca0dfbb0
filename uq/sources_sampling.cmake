set(UQ_SAMPLING_SOURCES
    stream.cpp)
