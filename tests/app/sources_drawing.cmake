drystone_tests(app_drawing
    SOURCES
        app/drawing_scenes.cpp
        app/test_bad_drawing.cpp
        app/test_drawing_fit.cpp
        app/test_dxf_drawing.cpp
        app/test_json_drawing.cpp
    LIBRARIES drystone_app_drawing
    DEFINITIONS DRYSTONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
