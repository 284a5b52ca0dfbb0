#pragma once
/// Names of files of studies.

#include <filesystem>
#include <string>
#include <string_view>

namespace app {

/// Whether a path is that of the file of a study, as all verbs know it: FILE.h5 or FILE.hdf5.
[[nodiscard]] constexpr bool is_study_name(std::string_view path)
{
    return path.ends_with(".h5") || path.ends_with(".hdf5");
}

/// Name of a study on a page: that of its file, or of the folder of a push, whose study is
/// always study.ini.
[[nodiscard]] inline std::string study_title(const std::filesystem::path& path)
{
    const std::string name = path.stem().string(),
                      folder = path.parent_path().filename().string();
    return path.filename() == "study.ini" && !folder.empty() ? folder : name;
}

} // namespace app
