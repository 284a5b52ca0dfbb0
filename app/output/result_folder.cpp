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
#include <stdexcept>

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

/// Entry of the list in place of a check sum for a file that was moved here: nobody needs to
/// read it again.
constexpr std::string_view kMoved = "moved";

/// Names and check sums; a name that leads out of the folder is not ours.
using List = std::map<std::string, std::string>;

List read_list(const fs::path& folder, std::string_view list_name)
{
    List list;
    std::istringstream in(content_of(folder / list_name));
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

void check_foreign(const fs::path& folder, const std::vector<fs::path>& names,
                   const List& before)
{
    std::error_code ignored;
    for (const fs::path& name : names)
        if (fs::exists(folder / name, ignored) && before.count(name.string()) == 0)
            throw ConfigError(
                "--out", 0, (folder / name).string(),
                "exists already and was not written by an earlier run of this version; "
                "give another folder, or move the file away");
}

void move_file(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
        throw std::runtime_error("cannot write '" + to.string() + "': " + error.message());
}

} // namespace

std::string check_results(const fs::path& folder, const std::vector<fs::path>& names,
                          std::string_view list)
{
    const List before = read_list(folder, list);
    check_foreign(folder, names, before);
    if (before.empty()) return "";
    return "note: " + folder.string() +
           " has results of an earlier run, which will be replaced\n";
}

std::size_t write_results(const fs::path& folder, const std::vector<OutputFile>& files,
                          std::string_view list)
{
    const List before = read_list(folder, list);
    std::vector<fs::path> names;
    for (const OutputFile& f : files) names.push_back(f.name);
    check_foreign(folder, names, before);
    List now, either = before;
    std::set<fs::path> folders = {folder};
    for (const OutputFile& f : files) {
        either[f.name.string()] = now[f.name.string()] =
            f.from.empty() ? check_sum(f.content) : std::string(kMoved);
        folders.insert((folder / f.name).parent_path());
    }
    for (const fs::path& f : folders) make_folder(f);
    write_file(folder / list, list_text(either)); // a kill leaves no file that is not ours
    std::error_code ignored;
    for (const auto& [name, sum] :
         before) // in the order of names: joints.pvd before joints_0000.vtu
        if (sum == kMoved) fs::remove(folder / name, ignored);
    for (const OutputFile& f : files)
        f.from.empty() ? write_file(folder / f.name, f.content)
                       : move_file(f.from, folder / f.name);
    std::size_t removed = 0;
    for (const auto& [name, sum] : before)
        if (now.count(name) == 0 && check_sum(content_of(folder / name)) == sum)
            removed += fs::remove(folder / name) ? 1 : 0;
    std::error_code not_empty;
    for (const auto& [name, sum] : before)
        if (const fs::path parent = (folder / name).parent_path(); parent != folder)
            fs::remove(parent, not_empty);
    write_file(folder / list, list_text(now));
    return removed;
}

void add_results(const fs::path& folder, const std::vector<OutputFile>& files,
                 std::string_view list)
{
    List all = read_list(folder, list);
    std::vector<fs::path> names;
    for (const OutputFile& f : files) names.push_back(f.name);
    check_foreign(folder, names, all);
    make_folder(folder);
    for (const OutputFile& f : files) all[f.name.string()] = check_sum(f.content);
    write_file(folder / list, list_text(all)); // first, as in write_results
    for (const OutputFile& f : files) {
        make_folder((folder / f.name).parent_path());
        write_file(folder / f.name, f.content);
    }
}

} // namespace app
