drystone_tests(app_record
    SOURCES
        app/push/test_record_command.cpp
    LIBRARIES drystone_app_record)
