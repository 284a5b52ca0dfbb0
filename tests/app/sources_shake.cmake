drystone_tests(app_shake
    SOURCES
        app/test_shake_command.cpp
    LIBRARIES drystone_app_shake)
