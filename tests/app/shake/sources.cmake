drystone_tests(app_shake
    SOURCES
        app/shake/test_shake_command.cpp
        app/shake/test_shake_study.cpp
        app/shake/test_shaken_report.cpp
    LIBRARIES drystone_app_fragility drystone_app_report drystone_app_shake)
