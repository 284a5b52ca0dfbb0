set(TEST_UQ_ANALYSIS_SOURCES
    uq/test_field.cpp
    uq/test_field_basis.cpp
    uq/test_karhunen.cpp
    uq/test_kernel.cpp)
