# Links drystone_app_push and nlohmann_json.
set(TEST_APP_PUSH_SOURCES
    app/bad_input/studies.cpp
    app/drawing_scenes.cpp
    app/test_capacity_svg.cpp
    app/test_direction.cpp
    app/test_drawn_ends.cpp
    app/test_drawn_picture.cpp
    app/test_hand_checks.cpp
    app/test_pier_balance.cpp
    app/test_pier_reading.cpp
    app/test_scene.cpp
    app/test_pushed_series.cpp
    app/test_summary_json.cpp
    app/test_table.cpp
    app/test_wall_numbers.cpp)
