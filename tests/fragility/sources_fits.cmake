# Statistics of limit displacements and modes: needs drystone_fragility alone, so that it builds fast.
drystone_tests(fragility_fits
    SOURCES
        fragility/test_censored_fit.cpp
        fragility/test_fit_intervals.cpp
        fragility/test_standard_law.cpp
    LIBRARIES drystone_fragility)
