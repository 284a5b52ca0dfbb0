# Statistics of limit displacements and modes: needs drystone_fragility alone, so that it builds fast.
drystone_tests(fragility_fits
    SOURCES
        fragility/fits/test_censored_fit.cpp
        fragility/intensity/test_cloud.cpp
        fragility/intensity/test_crossed_design.cpp
        fragility/intensity/test_sufficiency.cpp
        fragility/fits/test_fit_intervals.cpp
        fragility/limits/test_fragility_curve.cpp
        fragility/fits/test_goodness_of_fit.cpp
        fragility/limits/test_hierarchical_normal.cpp
        fragility/intensity/test_ida.cpp
        fragility/intensity/test_intensity_fit.cpp
        fragility/fits/test_kaplan_meier.cpp
        fragility/fits/test_law_parameters.cpp
        fragility/limits/test_limit_quantiles.cpp
        fragility/fits/test_median_bound.cpp
        fragility/fits/test_observation.cpp
        fragility/fits/test_observed_quantile.cpp
        fragility/curve/test_resampled_curve.cpp
        fragility/modes/test_mode_lack_of_fit.cpp
        fragility/modes/test_mode_model.cpp
        fragility/limits/test_model_factor.cpp
        fragility/laws/test_maximise.cpp
        fragility/fits/test_share.cpp
        fragility/laws/test_standard_law.cpp
        fragility/limits/test_stress_model.cpp
        fragility/modes/test_ordinal_fit.cpp
        fragility/fits/test_survival_data.cpp
    LIBRARIES drystone_fragility drystone_uq_sampling)

# Random data sets against R; skipped where R or its packages survival, MASS, nnet are missing.
add_test(NAME "fragility_fits: R agrees"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/fragility/check_survival.sh $<TARGET_FILE:test_fragility_fits>)
set_tests_properties("fragility_fits: R agrees" PROPERTIES SKIP_RETURN_CODE 77)
