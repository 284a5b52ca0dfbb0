#include "app/fragility/drift_csv.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/text_file.hpp"
#include "app/text/words.hpp"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <locale>
#include <map>

namespace app {

bool read_censored(const Csv& csv, const CsvRow& row, std::size_t column)
{
    const std::string text =
        boost::to_lower_copy(std::string(trimmed(row.cells[column])), std::locale::classic());
    for (const char* const yes : {"1", "yes", "y", "true", "censored"})
        if (text == yes) return true;
    for (const char* const no : {"0", "no", "n", "false", "observed"})
        if (text == no) return false;
    refuse_cell(csv, row, column,
                in_quotes(text) + " does not say whether the value is a bound; write 1, yes or "
                                  "censored, or 0, no or observed");
}

bool is_missing(std::string_view text)
{
    for (const char* const none : {"", "NA", "N/A", "na", "n/a", "-"})
        if (text == none) return true;
    return false;
}

namespace {

std::string unit_of(std::string_view head)
{
    const auto open = head.find_first_of("[("), close = head.find_first_of("])", open);
    if (open == std::string_view::npos || close == std::string_view::npos) return {};
    return std::string(trimmed(head.substr(open + 1, close - open - 1)));
}

double percent_per_unit(const std::string& unit)
{
    if (unit == "%") return 1.0;
    if (unit == "-" || unit == "rad" || unit == "m/m" || unit == "1") return 100.0;
    if (unit == "permille" || unit == "‰" || unit == "mm/m" || unit == "mrad") return 0.1;
    return 0.0;
}

/// Indices of the columns asked for.
struct Indices {
    std::vector<std::size_t> drift;
    std::vector<std::size_t> censored; ///< none, one of all drifts, or one for each
    std::optional<std::size_t> group;
};

/// "2.27", "> 2.27" or ">= 2.27" (a bound), or nothing.
std::optional<fragility::Observation> drift_at(const Csv& csv, const CsvRow& row,
                                               std::size_t column, bool bound)
{
    std::string_view text = trimmed(row.cells[column]);
    if (is_missing(text)) return {};
    CsvRow plain = row;
    if (text.front() == '>') {
        bound = true;
        text.remove_prefix(text.starts_with(">=") ? 2 : 1);
        plain.cells[column] = std::string(trimmed(text));
    }
    const double d = number_at(csv, plain, column);
    if (!bound && d == 0.0)
        refuse_cell(
            csv, row, column,
            "is 0, where no limit state is reached; write the drift, or NA if it is not known");
    if (d == 0.0)
        refuse_cell(
            csv, row, column,
            "is a bound of 0, which says nothing of a wall; write the drift at which it "
            "still stood, or NA if it is not known");
    if (d < kLeastValue || d > kMostValue)
        refuse_cell(csv, row, column,
                    in_quotes(trimmed(text)) + " is no drift; it must be in [" +
                        number(kLeastValue, 3) + ", " + number(kMostValue, 3) + "]");
    return bound ? fragility::right_censored(d) : fragility::observed(d);
}

DriftWall read_wall(const Csv& csv, const Indices& columns, const CsvRow& row)
{
    DriftWall wall;
    for (std::size_t i = 0; i < columns.drift.size(); ++i) {
        bool bound = false;
        if (!columns.censored.empty() && !is_missing(trimmed(row.cells[columns.drift[i]]))) {
            const std::size_t c = columns.censored[columns.censored.size() == 1 ? 0 : i];
            bound = read_censored(csv, row, c);
        }
        wall.limits.push_back(drift_at(csv, row, columns.drift[i], bound));
    }
    return wall;
}

std::string group_name(const Csv& csv, const Indices& columns, const CsvRow& row)
{
    if (!columns.group) return "all";
    const std::string name(trimmed(row.cells[*columns.group]));
    if (name.empty()) refuse_cell(csv, row, *columns.group, "empty cell; name its group");
    return name;
}

/// Groups whose names are numbers are ordered by them.
void sort_groups(std::vector<DriftGroup>& groups)
{
    std::vector<std::pair<double, DriftGroup>> keyed;
    for (DriftGroup& g : groups) {
        double key = 0.0;
        const char* const last = g.name.data() + g.name.size();
        const auto [end, error] = std::from_chars(g.name.data(), last, key);
        if (error != std::errc() || end != last || !std::isfinite(key)) return;
        keyed.emplace_back(key, g);
    }
    std::ranges::stable_sort(keyed, {}, [](const auto& k) { return k.first; });
    for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = keyed[i].second;
}

/// One below the other, as many as fit on a screen.
std::string all_of(const std::vector<std::string>& messages)
{
    constexpr std::size_t kShown = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, messages.size()); ++i)
        text += "\n" + messages[i];
    if (messages.size() > kShown)
        text += "\nand " + std::to_string(messages.size() - kShown) + " more";
    return text;
}

} // namespace

Csv read_csv_file(const std::string& path)
{
    constexpr std::size_t kMostBytes = std::size_t{1} << 28;
    const std::string text = read_bytes(
        path, kMostBytes, "is larger than 256 MiB; give a table of walls", "give a file");
    if (!is_text(text))
        throw ConfigError(
            path, 0, "",
            "is not text in UTF-8; save it as \"CSV UTF-8\", or convert it: iconv "
            "-f latin1 -t utf-8 (of a table from Windows), -f utf-16 (\"Unicode "
            "text\")");
    return parse_csv(path, text);
}

DriftData drift_data(const Csv& csv, const DriftColumns& columns)
{
    check_rows(csv);
    Indices at;
    DriftData data;
    for (const std::string& name : columns.drift) {
        at.drift.push_back(find_column(csv, name));
        const std::string& head = csv.head[at.drift.back()];
        const std::string unit = unit_of(head);
        if (!data.states.empty() && unit != data.unit)
            throw ConfigError(csv.path, 0, head, "columns of drift must have one unit");
        data.unit = unit;
        data.states.push_back({"", std::string(bare_name(head)), "column " + in_quotes(head)});
    }
    for (const std::string& name : columns.censored)
        at.censored.push_back(find_column(csv, name));
    if (at.censored.size() > 1 && at.censored.size() != at.drift.size())
        throw ConfigError("drystone", 0, "--censored",
                          "given " + std::to_string(at.censored.size()) + " times for " +
                              std::to_string(at.drift.size()) +
                              " columns of drift; give it once, or once for each --drift");
    if (!columns.group.empty()) at.group = find_column(csv, columns.group);
    data.percent = percent_per_unit(data.unit);
    data.group_head = at.group ? csv.head[*at.group] : "group";
    data.source = std::filesystem::path(csv.path).filename().string();
    data.drift = "Values as given in the table";
    std::map<std::string, std::size_t> places;
    std::vector<std::string> wrong; // all rows are read, so that all mistakes are named at once
    std::size_t empty = 0;
    for (const CsvRow& row : csv.rows) try {
            DriftWall wall = read_wall(csv, at, row);
            for (const auto& limit : wall.limits) empty += limit ? 0 : 1;
            const std::string name = group_name(csv, at, row);
            const auto [place, fresh] = places.emplace(name, data.groups.size());
            if (fresh) data.groups.push_back({name, {}, {}, 0, 0, {}});
            data.groups[place->second].walls.push_back(std::move(wall));
        } catch (const ConfigError& e) {
            wrong.emplace_back(e.what());
        }
    if (!wrong.empty())
        throw ConfigError(csv.path, 0, "",
                          std::to_string(wrong.size()) +
                              (wrong.size() == 1 ? " mistake:" : " mistakes:") + all_of(wrong));
    if (empty > 0)
        data.drift += "; " + std::to_string(empty) + (empty == 1 ? " cell" : " cells") +
                      " without a value (empty or NA) left out";
    sort_groups(data.groups);
    return data;
}

} // namespace app
