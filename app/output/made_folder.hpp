#pragma once
/// A folder that goes again if nothing stays in it.

#include <filesystem>

namespace app {

/// Makes the folder and its parents. A folder that was not there before, and is empty when this
/// ends, is removed.
class MadeFolder {
  public:
    /// @throws std::runtime_error as make_folder
    explicit MadeFolder(std::filesystem::path folder);
    ~MadeFolder();
    MadeFolder(const MadeFolder&) = delete;
    MadeFolder& operator=(const MadeFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool is_new_ = false;
};

} // namespace app
