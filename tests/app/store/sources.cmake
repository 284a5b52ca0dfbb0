set(TEST_APP_STORE_SOURCES
    app/store/store_scene.cpp
    app/store/test_merge.cpp
    app/store/test_store.cpp
    app/store/test_store_disk.cpp
    app/store/test_store_parts.cpp
    app/store/test_store_strangers.cpp
    app/store/test_store_kill.cpp
    app/store/test_store_memory.cpp
    app/store/test_store_study.cpp
    fuzz/crafted_hdf5.cpp
    fuzz/test_crafted_store.cpp
    fuzz/test_store_fuzz.cpp)

drystone_tests(app_store
    SOURCES ${TEST_APP_STORE_SOURCES}
    LIBRARIES drystone_app_store drystone_uq_sampling hdf5::hdf5)

# The lines of docs/store.md, run on a study that the test program writes; skipped where python3-h5py is missing.
add_test(NAME "app_store: h5py reads the study as documented"
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/app/store/read_store.py
                 $<TARGET_FILE:test_app_store> ${PROJECT_SOURCE_DIR}/docs/store.md)
set_tests_properties("app_store: h5py reads the study as documented" PROPERTIES SKIP_RETURN_CODE 77)

# Its lines for xarray and R, where their packages are.
add_test(NAME "app_store: xarray and R read the study as documented"
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app/fragility/read_tables.sh $<TARGET_FILE:drystone>
                 ${PROJECT_SOURCE_DIR}/configs/quick.ini ${PROJECT_SOURCE_DIR}/docs/store.md)
set_tests_properties("app_store: xarray and R read the study as documented" PROPERTIES SKIP_RETURN_CODE 77 LABELS "study;slow")
