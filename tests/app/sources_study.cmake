set(TEST_APP_STUDY_SOURCES
    app/test_key_effects.cpp
    app/test_reliability.cpp
    app/test_sample_plan.cpp
    app/test_study_identity.cpp
    app/test_study_runner.cpp
    fuzz/test_study_fuzz.cpp)
