drystone_tests(app_report
    SOURCES
        app/fragility_scenes.cpp
        app/test_film_shelf.cpp
        app/test_one_reading.cpp
        app/test_report_bytes.cpp
        app/test_random_layouts.cpp
        app/test_report_choice.cpp
        app/test_report_curves.cpp
        app/test_report_cycles.cpp
        app/test_report_film.cpp
        app/test_report_overview.cpp
        app/test_report_page.cpp
        app/test_report_fragility.cpp
        app/test_report_study.cpp
        app/test_wall_reading.cpp
        scenes/snapshot_scenes.cpp
    LIBRARIES drystone_app_push drystone_app_report nlohmann_json::nlohmann_json ZLIB::ZLIB)
