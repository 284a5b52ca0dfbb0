# Needs scenes/paper_wall.cpp.
set(TEST_DEM_UNIT_SOURCES
    dem/test_block_element.cpp
    dem/test_condensation.cpp
    dem/test_drive.cpp
    dem/test_energy.cpp
    dem/test_face_rule.cpp
    dem/test_layout.cpp
    dem/test_mechanism.cpp
    dem/test_model.cpp
    dem/test_recorder.cpp
    dem/test_wall.cpp
    dem/test_zones.cpp
    scenes/snapshot_scenes.cpp)
