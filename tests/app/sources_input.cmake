# Needs DRYSTONE_PROGRAM (path of the built program) and DRYSTONE_SOURCE_DIR as compile definitions.
set(TEST_APP_INPUT_SOURCES
    app/bad_input/commands.cpp
    app/bad_input/studies.cpp
    app/test_bad_input.cpp
    app/test_bad_study.cpp
    app/test_command_line.cpp
    app/test_distribution_text.cpp
    app/test_docs.cpp
    app/test_joint_laws.cpp
    app/test_needed_cracks.cpp
    app/test_protocol_scale.cpp
    app/test_study.cpp
    app/test_study_file.cpp
    app/test_study_keys.cpp
    app/test_study_scene.cpp
    app/test_units.cpp
    app/test_words.cpp)
