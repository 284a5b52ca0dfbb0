#pragma once
/// The [wall] keys that read an exported drawing back as the same wall.

#include <string>

namespace app {

struct Study;

/// The unit of the files, and the keys of [wall] to write beside wall.geometry, one a line.
/// @param cracked whether units have potential cracks
[[nodiscard]] std::string reading_again_text(const Study& study, bool cracked);

} // namespace app
