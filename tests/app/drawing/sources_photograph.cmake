if(DRYSTONE_HAS_PHOTOGRAPHS)
    drystone_tests(app_photograph
        SOURCES
            app/drawing/photograph_scenes.cpp
            app/drawing/test_photograph.cpp
        LIBRARIES drystone_app_input drystone_app_photograph ${TURBOJPEG_LIBRARY})
endif()
