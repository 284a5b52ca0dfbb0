#include "app/store/store_parts.hpp"

#include "app/store/hdf5/store_disk.hpp"
#include "app/store/hdf5/store_error.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;

fs::path with_suffix(const fs::path& file, const char* suffix)
{
    fs::path name = linked_file(file);
    name += suffix;
    return name;
}

/// Whether it is there. Throws StoreError if it is there and no folder.
bool is_own_folder(const fs::path& folder)
{
    std::error_code error;
    const fs::file_type type = fs::symlink_status(folder, error).type();
    if (type != fs::file_type::not_found && type != fs::file_type::directory)
        throw StoreError(
            "'" + folder.string() +
            "' must be a folder of its own, with walls of the study; move it away");
    return type == fs::file_type::directory;
}

/// Names in the folder; none if there is no folder.
std::vector<fs::path> names_in(const fs::path& folder)
{
    if (!is_own_folder(folder)) return {};
    std::error_code error;
    std::vector<fs::path> names;
    for (fs::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error))
        names.push_back(at->path().filename());
    if (error && error != std::errc::no_such_file_or_directory)
        disk_error("read", folder, error.value());
    return names;
}

} // namespace

fs::path linked_file(const fs::path& file)
{
    std::error_code error;
    if (!fs::is_symlink(file, error)) return file;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

fs::path lock_of(const fs::path& file) { return with_suffix(file, ".lock"); }
fs::path parts_of(const fs::path& file) { return with_suffix(file, ".parts"); }

fs::path part_of(const fs::path& file, std::uint32_t number)
{
    std::string name = std::to_string(number);
    name.insert(0, name.size() < 6 ? 6 - name.size() : 0, '0');
    return parts_of(file) / (name + ".h5");
}

std::vector<std::uint32_t> part_numbers(const fs::path& file)
{
    std::vector<std::uint32_t> numbers;
    for (const fs::path& name : names_in(parts_of(file))) {
        const std::string stem = name.stem().string();
        const bool ours = name.extension() == ".h5" && stem.size() >= 6 && stem.size() <= 9 &&
                          stem.find_first_not_of("0123456789") == std::string::npos;
        if (ours) numbers.push_back(static_cast<std::uint32_t>(std::stoul(stem)));
    }
    std::ranges::sort(numbers);
    return numbers;
}

void check_parts_folder(const fs::path& file)
{
    static_cast<void>(is_own_folder(parts_of(file)));
}

void make_parts_folder(const fs::path& file)
{
    const fs::path folder = parts_of(file);
    if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
        disk_error("make folder", folder, errno);
    sync_folder_of(folder);
}

void remove_parts(const fs::path& file, const std::vector<std::uint32_t>& numbers)
{
    for (const std::uint32_t number : numbers) {
        const fs::path part = part_of(file, number);
        if (::unlink(part.c_str()) != 0 && errno != ENOENT) disk_error("remove", part, errno);
    }
    const fs::path folder = parts_of(file);
    for (const fs::path& name : names_in(folder))
        if (name.extension() == ".tmp") ::unlink((folder / name).c_str());
    ::rmdir(folder.c_str()); // others may have put something there
}

} // namespace app
