set(UQ_SURROGATE_SOURCES
    surrogates/chaos_fit.cpp
    surrogates/gaussian_process.cpp
    surrogates/polynomial_chaos.cpp
    surrogates/polynomials.cpp
    surrogates/process_fit.cpp
    surrogates/process_kernel.cpp)
