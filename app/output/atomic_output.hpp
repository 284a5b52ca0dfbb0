#pragma once
/// Output files that appear complete or not at all.

#include <filesystem>
#include <string_view>

namespace app {

/// Creates `folder` and its parents where they are missing.
/// Throws std::runtime_error naming the folder and the reason.
void make_folder(const std::filesystem::path& folder);

/// A file that is written piece by piece and appears once all of it is there: complete, or not
/// at all.
class NewFile {
  public:
    /// Opens a temporary in the folder of `path`. Throws std::runtime_error as write_file.
    explicit NewFile(std::filesystem::path path);
    ~NewFile(); ///< removes the temporary unless it was finished
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    void add(std::string_view content); ///< throws as write_file
    void finish();                      ///< gives it its name; throws as write_file

  private:
    std::filesystem::path path_, temporary_;
    int file_ = -1;
};

/// Writes `content` to a temporary in the folder of `path`, then renames it to `path`. A file
/// that was there is replaced, or left as it was if anything fails; a kill leaves at most the
/// temporary. Does not wait for the disk: a power cut may lose it. Throws std::runtime_error
/// naming the path and the reason (no such folder, disk full, permission, not a regular file).
void write_file(const std::filesystem::path& path, std::string_view content);

} // namespace app
