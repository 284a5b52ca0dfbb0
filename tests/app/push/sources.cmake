# Links drystone_app_push and nlohmann_json.
set(TEST_APP_PUSH_SOURCES
    app/bad_input/studies.cpp
    app/drawing/drawing_scenes.cpp
    app/push/test_capacity_svg.cpp
    app/push/test_cycle_parts.cpp
    app/push/test_direction.cpp
    app/push/test_drawn_ends.cpp
    app/push/test_drawn_picture.cpp
    app/push/test_hand_checks.cpp
    app/push/test_measured_curve.cpp
    app/push/test_pier_balance.cpp
    app/push/test_pier_reading.cpp
    app/push/test_scene.cpp
    app/push/test_pushed_series.cpp
    app/push/test_summary_json.cpp
    app/push/test_table.cpp
    app/push/test_wall_numbers.cpp)
