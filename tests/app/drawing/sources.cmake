drystone_tests(app_drawing
    SOURCES
        app/drawing/drawing_scenes.cpp
        app/drawing/test_bad_drawing.cpp
        app/drawing/test_drawing_fit.cpp
        app/drawing/test_drawing_fuzz.cpp
        app/drawing/test_dxf_blocks.cpp
        app/drawing/test_dxf_drawing.cpp
        app/drawing/test_json_drawing.cpp
        app/drawing/test_picture_drawing.cpp
        app/drawing/test_svg_drawing.cpp
        app/drawing/test_svg_page.cpp
        app/drawing/test_svg_paints.cpp
        app/drawing/test_write_drawing.cpp
    LIBRARIES drystone_app_drawing PNG::PNG
    DEFINITIONS DRYSTONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
