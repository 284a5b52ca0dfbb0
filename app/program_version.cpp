#include "app/program_version.hpp"

#include "app/version.hpp"

namespace app {

std::string program_version()
{
    return std::string(kVersion) +
           (commit().empty() ? "" : ", commit " + std::string(commit()));
}

} // namespace app
