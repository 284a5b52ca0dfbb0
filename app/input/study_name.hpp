#pragma once
/// Names of files of studies.

#include <string_view>

namespace app {

/// Whether a path is that of the file of a study, as all verbs know it: FILE.h5 or FILE.hdf5.
[[nodiscard]] constexpr bool is_study_name(std::string_view path)
{
    return path.ends_with(".h5") || path.ends_with(".hdf5");
}

} // namespace app
