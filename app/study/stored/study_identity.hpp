#pragma once
/// The identity of a study: a results file can be continued only by the study that began it.

#include <string>

namespace app {

struct Study;

/// Revision of the solver and all values that move a result, one `key = value` per line, in a
/// fixed form: how numbers were written, and whether they are defaults, makes no difference.
/// The number of samples is not among them.
[[nodiscard]] std::string identity_text(const Study& study);

} // namespace app
