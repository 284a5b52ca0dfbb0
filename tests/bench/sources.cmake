# What the benchmarks count and how they report it; their timings are no tests.
drystone_tests(bench PAGES
    SOURCES
        bench/test_accuracy.cpp
        bench/test_work_count.cpp
        scenes/paper_wall.cpp
        ../bench/speed/work_count.cpp
    LIBRARIES drystone_dem drystone_accuracy)

drystone_tests(validation PAGES
    SOURCES app/fragility/fragility_scenes.cpp bench/test_validation.cpp
    LIBRARIES drystone_validation)

drystone_tests(joint_laws PAGES
    SOURCES app/fragility/fragility_scenes.cpp bench/test_joint_laws.cpp
    LIBRARIES drystone_joint_laws
    DEFINITIONS DRYSTONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
