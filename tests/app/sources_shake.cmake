drystone_tests(app_shake
    SOURCES
        app/test_shake_command.cpp
        app/test_shake_study.cpp
        app/test_shaken_report.cpp
    LIBRARIES drystone_app_fragility drystone_app_report drystone_app_shake)
