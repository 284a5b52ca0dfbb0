find_path(HTTPLIB_INCLUDE_DIR httplib.h REQUIRED)
find_library(HTTPLIB_LIBRARY cpp-httplib) # where it is not compiled, the header is all

drystone_app_library(serve
    serve/http_connection.cpp
    serve/http_server.cpp
    serve/request_head.cpp
    serve/serve_command.cpp
    serve/served_surrogate.cpp
    serve/served_walls.cpp
    serve/umbridge.cpp
    serve/wall_queue.cpp)
target_link_libraries(drystone_app_serve
    PUBLIC drystone_app_reliability drystone_app_study drystone_app_surrogate
    PRIVATE nlohmann_json::nlohmann_json Threads::Threads)
# Two files alone have the header of HTTP, compiled as Debian's library is.
set(http_sources serve/http_connection.cpp serve/http_server.cpp)
set_source_files_properties(${http_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
if(HTTPLIB_LIBRARY)
    set_source_files_properties(${http_sources} PROPERTIES
        COMPILE_DEFINITIONS "CPPHTTPLIB_OPENSSL_SUPPORT;CPPHTTPLIB_ZLIB_SUPPORT;CPPHTTPLIB_BROTLI_SUPPORT")
    target_link_libraries(drystone_app_serve PRIVATE ${HTTPLIB_LIBRARY})
    # From version 0.18 on the header itself calls OpenSSL.
    file(STRINGS ${HTTPLIB_INCLUDE_DIR}/httplib.h calls_openssl REGEX "OPENSSL_thread_stop" LIMIT_COUNT 1)
    if(calls_openssl)
        find_library(CRYPTO_LIBRARY crypto REQUIRED)
        target_link_libraries(drystone_app_serve PRIVATE ${CRYPTO_LIBRARY})
    endif()
endif()
