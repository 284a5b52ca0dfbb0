#include "app/store/store_seal.hpp"

#include "app/store/store_error.hpp"
#include "app/store/store_head.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n"; ///< any HDF5 file without a user block
constexpr std::string_view kTitle = "drystone study, HDF5 from byte 512\nlayout ";

std::string seal_text(std::uint64_t length, std::uint32_t sum)
{
    std::array<char, 100> rest{};
    std::snprintf(rest.data(), rest.size(), "%u\nbytes %020llu\ncrc32 %08x\n", kStoreLayout,
                  static_cast<unsigned long long>(length), static_cast<unsigned>(sum));
    std::string text = std::string(kTitle) + rest.data();
    text.resize(kSealBytes, '\0');
    return text;
}

std::uint32_t sum_of_rest(const OpenFile& file, const fs::path& path)
{
    std::vector<char> block(1 << 20);
    std::uint32_t sum = 0;
    std::uint64_t offset = kSealBytes;
    while (const std::size_t n = read_at(file, path, block.data(), block.size(), offset)) {
        sum = crc32_of({block.data(), n}, sum);
        offset += n;
    }
    return sum;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why)
{
    throw StoreError("'" + path.string() + "' " + why);
}

/// Why a file that begins like this is refused before its rest is summed; does nothing for ours.
void check_beginning(const fs::path& path, std::string_view beginning)
{
    if (beginning.empty()) refuse(path, "is empty; remove it and run the study again");
    if (beginning.starts_with(kHdf5))
        refuse(path, "is an HDF5 file, but not of a study: the first 512 bytes that say so are "
                     "missing (h5repack drops them)");
    if (!beginning.starts_with(kTitle))
        refuse(path, "is not the file of a study, or its beginning is damaged");
    const std::string number = std::to_string(kStoreLayout) + "\n";
    if (!beginning.substr(kTitle.size()).starts_with(number)) {
        std::string layout(beginning.substr(kTitle.size(), 10));
        layout.resize(std::min(layout.find('\n'), layout.size()));
        if (layout.empty() || layout.find_first_not_of("0123456789") != std::string::npos)
            refuse(path, "is damaged: its layout cannot be read");
        refuse(path, "has layout " + layout + ", this program knows " +
                         std::to_string(kStoreLayout) +
                         "; use the version of the program that wrote it, or run the study "
                         "again into another file");
    }
}

} // namespace

bool begins_as_study(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::string beginning(kTitle.size(), '\0');
    in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    return beginning == kTitle || beginning.starts_with(kHdf5);
}

void write_seal(const OpenFile& file, const fs::path& path)
{
    const std::string seal = seal_text(file_length(file, path), sum_of_rest(file, path));
    if (const int error = write_at(file.get(), seal.data(), seal.size(), 0); error != 0)
        disk_error("write", path, error);
}

void check_seal(const OpenFile& file, const fs::path& path)
{
    std::array<char, kSealBytes> bytes{};
    const std::size_t n = read_at(file, path, bytes.data(), bytes.size(), 0);
    const std::string_view seal(bytes.data(), n);
    check_beginning(path, seal);
    if (seal != seal_text(file_length(file, path), sum_of_rest(file, path)))
        refuse(path, "is damaged, cut short or changed by another program (its checksum is "
                     "wrong); take a copy of it from before, or run the study again");
}

} // namespace app
