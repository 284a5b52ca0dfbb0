# Files of this folder as C++: cmake -D FOLDER=report -D MODULES=a.js,b.js -D OUT=x.cpp -P embed.cmake
# Modules become one script in the order given: their lines "import ..." are dropped and "export" is taken off, so
# that names are theirs alone across modules.
string(REPLACE "," ";" modules "${MODULES}")

function(put function text)
    string(HEX "${text}" hex)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    file(APPEND ${OUT}.part
        "std::string_view ${function}()\n{\n    static constexpr unsigned char kBytes[] = {${bytes}0};\n"
        "    return {reinterpret_cast<const char*>(kBytes), sizeof kBytes - 1};\n}\n\n")
endfunction()

set(script "'use strict';\n(() => {\n")
foreach(module IN LISTS modules)
    file(READ ${FOLDER}/${module} text)
    string(REGEX REPLACE "(^|\n)import [^\n]*" "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(APPEND script "${text}")
endforeach()
string(APPEND script "})();\n")

file(READ ${FOLDER}/page.html page)
file(READ ${FOLDER}/style.css style)
file(READ ${FOLDER}/vendor/uPlot.min.css chart_style)
file(READ ${FOLDER}/vendor/uPlot.iife.min.js chart_script)
file(READ ${FOLDER}/vendor/uPlot.LICENSE licence)

file(WRITE ${OUT}.part "#include \"app/report/report_assets.hpp\"\n\nnamespace app {\n\n")
put(report_page_html "${page}")
put(report_style "${style}")
put(report_script "${script}")
put(chart_style "${chart_style}")
put(chart_script "/*\n${licence}*/\n${chart_script}")
file(APPEND ${OUT}.part "} // namespace app\n")
file(RENAME ${OUT}.part ${OUT})
