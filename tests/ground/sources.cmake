# Records, pulses and measures of ground motions: needs drystone_ground alone. Files of strangers are read where the
# environment variable DRYSTONE_RECORDS names their folder (formats/ and fema_p695/ in it); else those cases say so and pass.
drystone_tests(ground
    SOURCES
        ground/record_texts.cpp
        ground/test_call_text.cpp
        ground/test_intensity.cpp
        ground/test_oscillator.cpp
        ground/test_pulse.cpp
        ground/test_record.cpp
        ground/test_record_fuzz.cpp
        ground/test_shared_records.cpp
        ground/test_stochastic_motion.cpp
    LIBRARIES drystone_ground drystone_uq_sampling)
