drystone_app_library(calibration
    calibration/calibrate_command.cpp
    calibration/calibrated_inputs.cpp
    calibration/calibration_data.cpp
    calibration/calibration_pictures.cpp
    calibration/calibration_pushes.cpp
    calibration/calibration_run.cpp
    calibration/calibration_surrogate.cpp
    calibration/calibration_tables.cpp
    calibration/calibration_words.cpp
    calibration/measured_tests.cpp
    calibration/posterior_study.cpp
    calibration/test_columns.cpp
    calibration/test_notes.cpp
    calibration/tested_factor.cpp
    calibration/tested_quantity.cpp)
target_link_libraries(drystone_app_calibration PUBLIC drystone_app_fragility drystone_uq_surrogates PRIVATE Threads::Threads)
