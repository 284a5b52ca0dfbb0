# Statistics of limit displacements and modes: needs drystone_fragility alone, so that it builds fast.
drystone_tests(fragility_fits
    SOURCES
        fragility/test_censored_fit.cpp
        fragility/test_cloud.cpp
        fragility/test_crossed_design.cpp
        fragility/test_fit_intervals.cpp
        fragility/test_fragility_curve.cpp
        fragility/test_goodness_of_fit.cpp
        fragility/test_hierarchical_normal.cpp
        fragility/test_ida.cpp
        fragility/test_intensity_fit.cpp
        fragility/test_kaplan_meier.cpp
        fragility/test_law_parameters.cpp
        fragility/test_limit_quantiles.cpp
        fragility/test_median_bound.cpp
        fragility/test_observation.cpp
        fragility/test_observed_quantile.cpp
        fragility/test_resampled_curve.cpp
        fragility/test_mode_lack_of_fit.cpp
        fragility/test_mode_model.cpp
        fragility/test_model_factor.cpp
        fragility/test_maximise.cpp
        fragility/test_share.cpp
        fragility/test_standard_law.cpp
        fragility/test_stress_model.cpp
        fragility/test_ordinal_fit.cpp
        fragility/test_survival_data.cpp
    LIBRARIES drystone_fragility drystone_uq_sampling)

# Random data sets against R; skipped where R or its packages survival, MASS, nnet are missing.
add_test(NAME "fragility_fits: R agrees"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/fragility/check_survival.sh $<TARGET_FILE:test_fragility_fits>)
set_tests_properties("fragility_fits: R agrees" PROPERTIES SKIP_RETURN_CODE 77)
