#pragma once
/// Cost of a contact under each law.

#include <string>

namespace bench {

/// Nanoseconds per update of a register of contacts: dry law, crack law, crack law as far as
/// its elastic trial; a section of Markdown.
[[nodiscard]] std::string law_cost_text();

} // namespace bench
