#include "app/store/hdf5/store_error.hpp"

namespace app {

void damaged(const std::filesystem::path& file, const std::string& why)
{
    const bool part = file.parent_path().extension() == ".parts";
    throw BadStoredStudy(
        "'" + file.string() + "' is damaged: " + why +
        (part ? "; remove it and run the same command again: its walls will be run again"
              : "; restore an earlier copy of it, or run the study again into another file"));
}

} // namespace app
