drystone_tests(app_fragility
    SOURCES
        app/fragility_scenes.cpp
        app/test_damage_counts.cpp
        app/test_drift_csv.cpp
        app/test_drift_limits.cpp
        app/test_fragility_cycles.cpp
        app/test_fragility_limits.cpp
        app/test_fragility_means.cpp
        app/test_fragility_modes.cpp
        app/test_fragility_output.cpp
        app/test_fragility_pelicun.cpp
        app/test_fragility_states.cpp
        app/test_fragility_study.cpp
        app/test_fragility_text.cpp
        app/test_solver_error.cpp
        fragility/test_user_limit_states.cpp
    LIBRARIES drystone_app_fragility drystone_app_verbs nlohmann_json::nlohmann_json)
