#include "app/store/store_head.hpp"

#include "app/store/store_error.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

namespace app {

namespace {

constexpr const char* kNameCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+()[]";

void require(bool good, const std::string& what)
{
    if (!good) throw std::invalid_argument("store: " + what);
}

void check_columns(const char* list, const std::vector<Column>& columns)
{
    std::set<std::string> names;
    for (const Column& column : columns) {
        const std::string& name = column.name;
        require(!name.empty() && name != "." && name != ".." && name.size() <= 200 &&
                    name.find_first_not_of(kNameCharacters) == std::string::npos,
                std::string(list) + ": column name '" + name +
                    "' must be of letters, digits and _-.+()[]");
        require(names.insert(name).second,
                std::string(list) + ": column '" + name + "' is there twice");
    }
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Column lists as text, for the difference that is shown.
std::string columns_text(const StoreHead& head)
{
    std::string text;
    const auto add = [&text](const char* list, const std::vector<Column>& columns) {
        for (const Column& c : columns)
            text += std::string(list) + " " + c.name + " [" + c.unit + "] " + c.meaning + "\n";
    };
    add("input", head.inputs);
    add("response", head.responses);
    add("count", head.counts);
    add("cost", head.cost);
    add("curve", head.curve_columns);
    return text;
}

[[noreturn]] void refuse(const std::string& file, const std::string& why)
{
    throw StoreError(file + ": " + why +
                     "\nUse another output file, or the inputs of this one.");
}

void check_levels(const std::string& file, const StoreHead& stored, const StoreHead& wanted)
{
    for (std::size_t k = 0; k < stored.levels.size(); ++k) {
        const StoreLevel& before = stored.levels[k];
        if (k >= wanted.levels.size())
            refuse(file, "has " + std::to_string(stored.levels.size()) +
                             " levels of vertical stress, wanted are " +
                             std::to_string(wanted.levels.size()));
        if (!(wanted.levels[k].vertical_stress == before.vertical_stress))
            refuse(file, "level " + std::to_string(k) + " has another vertical stress");
        if (wanted.levels[k].samples < before.samples)
            refuse(file, "has " + std::to_string(before.samples) + " samples at level " +
                             std::to_string(k) + ", only " +
                             std::to_string(wanted.levels[k].samples) + " are wanted");
    }
}

std::uint32_t most_samples(const std::vector<StoreLevel>& levels)
{
    std::uint32_t most = 0;
    for (const StoreLevel& level : levels) most = std::max(most, level.samples);
    return most;
}

} // namespace

void check_head(const StoreHead& head)
{
    for (const StoreLevel& level : head.levels)
        require(std::isfinite(level.vertical_stress), "vertical stress must be finite");
    require(head.levels.size() <= 1'000'000, "levels must be at most 1000000");
    require(head.shards >= 1 && head.shard < head.shards,
            "shard " + std::to_string(head.shard) + " must be in [0, " +
                std::to_string(head.shards) + ")");
    require(head.compression >= 0 && head.compression <= 9,
            "compression " + std::to_string(head.compression) + " must be in [0, 9]");
    require(std::ranges::adjacent_find(head.design_sizes, std::greater_equal{}) ==
                head.design_sizes.end(),
            "design sizes must increase");
    check_columns("inputs", head.inputs);
    check_columns("responses", head.responses);
    check_columns("counts", head.counts);
    check_columns("cost", head.cost);
    check_columns("curve", head.curve_columns);
    for (const Column& column : head.curve_columns)
        require(column.name != "displacement" && column.name != "force" &&
                    column.name != "offset",
                "curve: column '" + column.name + "' is there already");
}

std::string text_difference(const std::string& before, const std::string& after,
                            std::size_t most)
{
    const std::vector<std::string> a = lines_of(before), b = lines_of(after);
    const std::multiset<std::string> in_a(a.begin(), a.end()), in_b(b.begin(), b.end());
    std::vector<std::string> differing;
    for (const std::string& line : a)
        if (in_a.count(line) > in_b.count(line)) differing.push_back("- " + line);
    for (const std::string& line : b)
        if (in_b.count(line) > in_a.count(line)) differing.push_back("+ " + line);
    if (differing.empty() && before != after)
        differing.push_back("  the same lines in another order or with other line ends");
    std::string text;
    for (std::size_t k = 0; k < std::min(most, differing.size()); ++k)
        text += differing[k] + "\n";
    if (differing.size() > most)
        text += "and " + std::to_string(differing.size() - most) + " more lines\n";
    return text;
}

std::string study_difference(const StoreHead& stored, const StoreHead& other)
{
    if (stored.identity != other.identity)
        return "has other inputs (- there, + here):\n" +
               text_difference(stored.identity, other.identity);
    if (stored.seed != other.seed)
        return "has seed " + std::to_string(stored.seed) + ", not " +
               std::to_string(other.seed);
    if (stored.shard != other.shard || stored.shards != other.shards)
        return "has shard " + std::to_string(stored.shard) + " of " +
               std::to_string(stored.shards) + ", not " + std::to_string(other.shard) + " of " +
               std::to_string(other.shards);
    const std::string before = columns_text(stored), after = columns_text(other);
    if (before != after)
        return "has other columns (- there, + here):\n" + text_difference(before, after);
    return {};
}

StoreHead continued_head(const std::string& file, const StoreHead& stored,
                         const StoreHead& wanted)
{
    if (const std::string why = study_difference(stored, wanted); !why.empty())
        refuse(file, why);
    check_levels(file, stored, wanted);

    StoreHead head = wanted;
    head.design_sizes = stored.design_sizes;
    const std::uint32_t largest = most_samples(wanted.levels);
    if (largest > (head.design_sizes.empty() ? 0 : head.design_sizes.back()))
        head.design_sizes.push_back(largest);
    head.sessions = stored.sessions;
    head.sessions.insert(head.sessions.end(), wanted.sessions.begin(), wanted.sessions.end());
    head.compression = stored.compression;
    head.single_precision_curves = stored.single_precision_curves;
    return head;
}

} // namespace app
