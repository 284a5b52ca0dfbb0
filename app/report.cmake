# The page: files of report/ become arrays of bytes in report_assets.cpp, so that the program needs no file beside it.
set(report_modules format.js data.js chart.js loop.js capacity.js wall.js statistics.js tables.js surrogate.js whatif.js main.js)
set(report_files page.html style.css vendor/uPlot.min.css vendor/uPlot.iife.min.js vendor/uPlot.LICENSE
    ${report_modules})
list(TRANSFORM report_files PREPEND ${PROJECT_SOURCE_DIR}/report/)
set(report_assets ${PROJECT_BINARY_DIR}/generated/app/report_assets.cpp)
string(REPLACE ";" "," modules "${report_modules}")
add_custom_command(
    OUTPUT ${report_assets}
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${PROJECT_SOURCE_DIR}/report -D MODULES=${modules} -D OUT=${report_assets}
            -P ${PROJECT_SOURCE_DIR}/report/embed.cmake
    DEPENDS ${report_files} ${PROJECT_SOURCE_DIR}/report/embed.cmake
    VERBATIM)
add_custom_target(report_assets DEPENDS ${report_assets}) # else it would wait for all libraries that the one below links

drystone_app_library(report
    ${report_assets}
    report/film_shelf.cpp
    report/report_answers.cpp
    report/report_assumed.cpp
    report/report_bytes.cpp
    report/report_choice.cpp
    report/report_command.cpp
    report/report_curves.cpp
    report/report_cycles.cpp
    report/report_data.cpp
    report/report_film.cpp
    report/report_fragility.cpp
    report/report_inputs.cpp
    report/report_overview.cpp
    report/report_page.cpp
    report/report_replay.cpp
    report/report_whatif.cpp
    report/shaken_report.cpp)
target_include_directories(drystone_app_report PUBLIC ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(drystone_app_report PUBLIC drystone_app_fragility drystone_app_shake drystone_app_surrogate nlohmann_json::nlohmann_json PRIVATE ZLIB::ZLIB)
