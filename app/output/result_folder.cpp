#include "app/output/result_folder.hpp"

#include "app/output/atomic_output.hpp"
#include "app/text/check_sum.hpp"
#include "app/text/config_error.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOpening =
    "# Files that drystone wrote here. The next run into this folder removes those it does not "
    "write again.\n";

std::string content_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Names and check sums; a name that leads out of the folder is not ours.
using List = std::map<std::string, std::string>;

List read_list(const fs::path& folder)
{
    List list;
    std::istringstream in(content_of(folder / kFileList));
    std::string sum, name;
    std::getline(in, name);
    if (name + "\n" != kOpening) return list;
    while (in >> sum && in.get() && std::getline(in, name)) {
        const fs::path path = fs::path(name).lexically_normal();
        if (path.is_relative() && !path.empty() && *path.begin() != "..") list[name] = sum;
    }
    return list;
}

std::string list_text(const List& list)
{
    std::string text(kOpening);
    for (const auto& [name, sum] : list) text += sum + " " + name + "\n";
    return text;
}

void check_foreign(const fs::path& folder, const std::vector<OutputFile>& files,
                   const List& before)
{
    std::error_code ignored;
    for (const OutputFile& f : files)
        if (fs::exists(folder / f.name, ignored) && before.count(f.name.string()) == 0)
            throw ConfigError(
                "--out", 0, (folder / f.name).string(),
                "is there already and is not from an earlier run of this version; "
                "give another folder, or move the file away");
}

} // namespace

std::size_t write_results(const fs::path& folder, const std::vector<OutputFile>& files)
{
    const List before = read_list(folder);
    check_foreign(folder, files, before);
    List now, either = before;
    std::set<fs::path> folders = {folder};
    for (const OutputFile& f : files) {
        either[f.name.string()] = now[f.name.string()] = check_sum(f.content);
        folders.insert((folder / f.name).parent_path());
    }
    for (const fs::path& f : folders) make_folder(f);
    write_file(folder / kFileList, list_text(either)); // a kill leaves no file that is not ours
    for (const OutputFile& f : files) write_file(folder / f.name, f.content);
    std::size_t removed = 0;
    for (const auto& [name, sum] : before)
        if (now.count(name) == 0 && check_sum(content_of(folder / name)) == sum)
            removed += fs::remove(folder / name) ? 1 : 0;
    std::error_code not_empty;
    for (const auto& [name, sum] : before)
        if (const fs::path parent = (folder / name).parent_path(); parent != folder)
            fs::remove(parent, not_empty);
    write_file(folder / kFileList, list_text(now));
    return removed;
}

} // namespace app
