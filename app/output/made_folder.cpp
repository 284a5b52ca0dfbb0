#include "app/output/made_folder.hpp"

#include "app/output/atomic_output.hpp"

#include <system_error>
#include <utility>

namespace app {

MadeFolder::MadeFolder(std::filesystem::path folder) : path_(std::move(folder))
{
    std::error_code ignored;
    is_new_ = !std::filesystem::exists(path_, ignored);
    make_folder(path_);
}

MadeFolder::~MadeFolder()
{
    std::error_code not_empty;
    if (is_new_) std::filesystem::remove(path_, not_empty);
}

} // namespace app
