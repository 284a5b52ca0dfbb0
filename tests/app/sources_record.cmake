drystone_tests(app_record
    SOURCES
        app/test_record_command.cpp
    LIBRARIES drystone_app_record)
