drystone_tests(app_drawing
    SOURCES
        app/drawing_scenes.cpp
        app/test_bad_drawing.cpp
        app/test_drawing_fit.cpp
        app/test_drawing_fuzz.cpp
        app/test_dxf_drawing.cpp
        app/test_json_drawing.cpp
        app/test_picture_drawing.cpp
        app/test_svg_drawing.cpp
        app/test_write_drawing.cpp
    LIBRARIES drystone_app_drawing PNG::PNG
    DEFINITIONS DRYSTONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
