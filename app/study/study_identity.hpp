#pragma once
/// What makes two studies the same: a file of walls is only gone on with by the same study.

#include "app/input/study.hpp"

#include <string>

namespace app {

/// All values that move a result, one `key = value` per line, in a fixed form: how numbers were written,
/// and whether they are defaults, makes no difference. The number of samples is not among them.
[[nodiscard]] std::string identity_text(const Study& study);

} // namespace app
