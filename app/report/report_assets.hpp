#pragma once
/// The files of report/ that go into every page, put into the program when it is built.

#include <string_view>

namespace app {

[[nodiscard]] std::string_view report_page_html(); ///< with places {{NAME}}
[[nodiscard]] std::string_view report_style();     ///< report/style.css
[[nodiscard]] std::string_view report_script();    ///< modules of report/ as one script
[[nodiscard]] std::string_view chart_script();     ///< uPlot, with its licence
[[nodiscard]] std::string_view chart_style();

} // namespace app
