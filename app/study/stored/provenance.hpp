#pragma once
/// Where and by what a study was run.

#include "app/store/store_head.hpp"

namespace app {

/// Session of this process, now. @param threads as used
[[nodiscard]] StoreSession this_session(int threads);

} // namespace app
