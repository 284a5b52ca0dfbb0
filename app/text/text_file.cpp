#include "app/text/text_file.hpp"

#include "app/text/config_error.hpp"

#include <boost/locale/utf.hpp>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace app {
namespace {

constexpr std::size_t kLargest = 1 << 20; // [bytes]; a study has a few thousand

} // namespace

std::string whole_path(const std::string& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};
    const std::filesystem::path path = std::filesystem::absolute(file, error);
    return error ? std::string() : path.lexically_normal().string();
}

bool is_text(std::string_view bytes)
{
    namespace utf = boost::locale::utf;
    for (const char *at = bytes.data(), *const end = at + bytes.size(); at != end;) {
        const utf::code_point c = utf::utf_traits<char>::decode(at, end);
        if (c == 0 || c == utf::illegal || c == utf::incomplete) return false;
    }
    return true;
}

std::string read_bytes(const std::string& path, std::size_t most, const std::string& too_large,
                       const std::string& remedy)
{
    const auto refuse = [&](const std::string& why) { throw ConfigError(path, 0, "", why); };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) refuse("is a directory; " + remedy);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const int cause = errno;
    if (!file)
        refuse("cannot be read (" + std::generic_category().message(cause) + "); " + remedy);
    std::string bytes, piece(1 << 16, '\0'); // bounded: a device cannot fill the memory
    while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())),
           file.gcount() > 0) {
        bytes.append(piece, 0, static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > most) refuse(too_large);
    }
    if (file.bad()) refuse("cannot be read to its end");
    return bytes;
}

std::string read_small_file(const std::string& path)
{
    return read_bytes(path, kLargest, "is larger than 1 MiB; this is not a study file",
                      "give a study file, such as configs/wall.ini");
}

} // namespace app
