/// The page reads no file: a wall comes from keys.

#include "app/drawing/outlines/drawing.hpp"
#include "app/text/config_error.hpp"
#include "app/text/text_file.hpp"

#include <boost/locale/utf.hpp>

namespace app {
namespace {

constexpr const char* kNoFiles = "this page reads no file and no outlines; describe the wall "
                                 "by courses, or take the program";

} // namespace

bool is_picture(const std::filesystem::path&) { return false; }
bool has_polylines(const std::filesystem::path&) { return false; }

Drawing fit_blocks(const std::string& file, int line, std::span<const DrawnBlock>)
{
    throw ConfigError(file, line, "wall.outlines", kNoFiles);
}

Drawing read_drawing(const std::filesystem::path& path, const DrawingOptions&)
{
    throw ConfigError(path.string(), 0, "", kNoFiles);
}

std::string read_bytes(const std::string& path, std::size_t, const std::string&,
                       const std::string&)
{
    throw ConfigError(path, 0, "", kNoFiles);
}

std::string read_small_file(const std::string& path)
{
    throw ConfigError(path, 0, "", kNoFiles);
}

std::string whole_path(const std::string&) { return {}; }

bool is_text(std::string_view bytes)
{
    namespace utf = boost::locale::utf;
    for (const char *at = bytes.data(), *const end = at + bytes.size(); at != end;) {
        const utf::code_point c = utf::utf_traits<char>::decode(at, end);
        if (c == 0 || c == utf::illegal || c == utf::incomplete) return false;
    }
    return true;
}

} // namespace app
