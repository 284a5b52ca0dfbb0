#pragma once
/// Which program this is.

#include <string>
#include <string_view>

namespace app {

/// The sources as `git describe --always --dirty` names them; empty where they are no git
/// checkout.
[[nodiscard]] std::string_view commit();

/// "0.2.0, commit b2abf97", or "0.2.0".
[[nodiscard]] std::string program_version();

} // namespace app
