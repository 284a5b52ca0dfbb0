set(UQ_ANALYSIS_SOURCES
    field.cpp
    field_basis.cpp
    field_marginal.cpp
    field_product.cpp
    karhunen.cpp
    kernel.cpp)
