# Installation of the libraries: cmake --install BUILD --component development
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(DRYSTONE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/drystone)

set_target_properties(drystone_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS drystone_flags EXPORT drystone-flags COMPONENT development)
install(EXPORT drystone-flags FILE drystone-flags-targets.cmake NAMESPACE drystone:: DESTINATION ${DRYSTONE_CMAKE_DIR} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/drystone-config.cmake.in ${PROJECT_BINARY_DIR}/cmake/drystone-config.cmake
    INSTALL_DESTINATION ${DRYSTONE_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/drystone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/drystone-config.cmake ${PROJECT_BINARY_DIR}/cmake/drystone-config-version.cmake
    DESTINATION ${DRYSTONE_CMAKE_DIR} COMPONENT development)

# The folder `part` as drystone::part: its libraries, the first of which is the one to link, and its public headers,
# which keep their paths below include/drystone. LINKED: what pkg-config is told of libraries of others.
function(drystone_install part)
    cmake_parse_arguments(I "" "" "LIBRARIES;HEADERS;LINKED" ${ARGN})
    list(GET I_LIBRARIES 0 first)
    target_sources(${first} INTERFACE FILE_SET public_headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${I_HEADERS})
    set_target_properties(${first} PROPERTIES EXPORT_NAME ${part})
    add_library(drystone::${part} ALIAS ${first})
    install(TARGETS ${I_LIBRARIES} EXPORT drystone-${part}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        FILE_SET public_headers DESTINATION include/drystone COMPONENT development)
    install(EXPORT drystone-${part} FILE drystone-${part}-targets.cmake NAMESPACE drystone:: DESTINATION ${DRYSTONE_CMAKE_DIR}
        COMPONENT development)
    set(libs)
    foreach(library IN LISTS I_LIBRARIES)
        get_target_property(type ${library} TYPE)
        if(type STREQUAL STATIC_LIBRARY)
            string(APPEND libs "-l${library} ")
        endif()
    endforeach()
    file(RELATIVE_PATH prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
    list(JOIN I_LINKED ", " requires)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/drystone.pc.in ${PROJECT_BINARY_DIR}/cmake/drystone-${part}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/cmake/drystone-${part}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
