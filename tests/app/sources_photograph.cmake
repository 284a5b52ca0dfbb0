if(DRYSTONE_HAS_PHOTOGRAPHS)
    drystone_tests(app_photograph
        SOURCES
            app/photograph_scenes.cpp
            app/test_photograph.cpp
        LIBRARIES drystone_app_input drystone_app_photograph ${TURBOJPEG_LIBRARY})
endif()
