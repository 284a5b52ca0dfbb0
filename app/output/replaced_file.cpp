#include "app/output/replaced_file.hpp"

#include "app/text/config_error.hpp"

#include <array>
#include <fstream>

namespace app {

std::string check_replaced(const std::filesystem::path& file, std::string_view mark)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return "";
    std::array<char, 1000> begin{};
    std::ifstream in(file, std::ios::binary);
    in.read(begin.data(), begin.size());
    const std::string_view text(begin.data(), static_cast<std::size_t>(in.gcount()));
    if (text.find(mark) == std::string_view::npos)
        throw ConfigError(
            "--out", 0, file.string(),
            "exists already and was not written by this command; give another name, or "
            "move the file away");
    return "note: " + file.string() + " is an earlier result and will be replaced\n";
}

} // namespace app
