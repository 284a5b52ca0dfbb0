#pragma once
/// All keys of study files as a page.

#include <string>

namespace app {

/// Markdown: one table for each section.
[[nodiscard]] std::string keys_page();

} // namespace app
