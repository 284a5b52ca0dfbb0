#include "app/compare/compared_limits.hpp"

#include "app/input/study_name.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/text/text_file.hpp"
#include "fragility/curve/drift.hpp"
#include "fragility/fits/observed_quantile.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMedian = 2; ///< of kComparedShares
constexpr int kDecimals = 3;

std::vector<ComparedLimit> limits_of_study(const std::string& path)
{
    const StudyWalls study = read_study_walls(path, {}, Keep::readings);
    const double confidence = study.study.fragility.confidence;
    std::vector<ComparedLimit> all;
    for (const StudyLevel& level : study.levels)
        for (std::size_t s = 0; s < study.states.size(); ++s) {
            std::vector<fragility::Observation> walls;
            for (const StudyWall& w : level.walls)
                if (const auto o = fragility::observation(
                        w.reading.limits.at(s), fragility::percent_per_metre(study.height)))
                    walls.push_back(*o);
            if (walls.empty()) continue;
            ComparedLimit c{study.name, state_name(study.states[s]), stress_cell(level.stress),
                            "observed", static_cast<double>(walls.size())};
            const auto found =
                fragility::observed_quantiles(walls, kComparedShares, confidence);
            for (std::size_t q = 0; q < found.size(); ++q)
                c.drifts.at(q) = found[q].value ? with_interval(*found[q].value,
                                                                found[q].interval, kDecimals)
                                                : Number{.lower = fragility::known_to(walls),
                                                         .decimals = kDecimals,
                                                         .sense = Sense::above};
            all.push_back(std::move(c));
        }
    return all;
}

/// A drift of a row of performance_limits and its interval.
Number drift_of(const Json& row, const std::string& name)
{
    for (const char* const unit : {" [%]", ""}) {
        const auto lower = number_in(row, name + " lower" + unit),
                   upper = number_in(row, name + " upper" + unit),
                   value = number_in(row, name + unit);
        if (value)
            return with_interval(*value, lower.value_or(kUnknown), upper.value_or(kUnknown),
                                 kDecimals);
        if (lower) return {.lower = *lower, .decimals = kDecimals, .sense = Sense::above};
    }
    return {};
}

std::string text_in(const Json& row, const char* key)
{
    const auto at = row.find(key);
    return at != row.end() && at->is_string() ? at->get<std::string>() : std::string();
}

Cell group_of(const Json& row)
{
    if (const auto stress = number_in(row, "stress [MPa]")) return given(*stress);
    for (const char* const key : {"stress [MPa]", "group"})
        if (std::string text = text_in(row, key); !text.empty()) return text;
    return std::string();
}

std::vector<ComparedLimit> limits_of_folder(const fs::path& folder)
{
    constexpr std::size_t kMost = std::size_t{256} << 20;
    constexpr std::array kNames = {"5 % drift", "16 % drift", "median drift", "84 % drift",
                                   "95 % drift"};
    const std::string file = (folder / kFragilityFile).string();
    std::vector<ComparedLimit> all;
    try {
        const Json json = json_of(read_bytes(file, kMost, "is larger than 256 MiB",
                                             "give the folder that drystone fragility wrote"));
        const std::string name = folder.filename().empty()
                                     ? folder.parent_path().filename().string()
                                     : folder.filename().string();
        for (const Json& row : json.at("tables").at("performance_limits").at("rows")) {
            ComparedLimit c{name, text_in(row, "limit state"), group_of(row),
                            text_in(row, "drifts from"), number_in(row, "n").value_or(0.0)};
            for (std::size_t q = 0; q < kNames.size(); ++q)
                c.drifts.at(q) = drift_of(row, kNames.at(q));
            all.push_back(std::move(c));
        }
    } catch (const Json::exception&) {
        throw ConfigError(file, 0, "",
                          "has no table of limit drifts; run drystone fragility again");
    }
    return all;
}

bool same_row(const ComparedLimit& a, const ComparedLimit& b)
{
    return a.state == b.state && cell_text(a.group) == cell_text(b.group);
}

/// The first of the same limit state and group.
const ComparedLimit& first_of(const std::vector<ComparedLimit>& all, const ComparedLimit& c)
{
    return *std::ranges::find_if(all, [&](const ComparedLimit& x) { return same_row(x, c); });
}

/// By what comes first.
std::vector<const ComparedLimit*> in_order(const std::vector<ComparedLimit>& all)
{
    std::vector<const ComparedLimit*> rows;
    for (const ComparedLimit& c : all) rows.push_back(&c);
    std::ranges::stable_sort(rows, {},
                             [&](const ComparedLimit* c) { return &first_of(all, *c); });
    return rows;
}

} // namespace

std::vector<ComparedLimit> read_limits(const std::string& path)
{
    if (is_study_name(path)) return limits_of_study(path);
    if (fs::exists(fs::path(path) / kFragilityFile)) return limits_of_folder(path);
    return {};
}

Table compared_limit_table(const std::vector<ComparedLimit>& all)
{
    Table t;
    t.title = "Limit drifts side by side";
    t.caption = "Drifts at which 16, 50 and 84 % of the walls have reached a limit state, with "
                "their intervals: of a file of results the shares observed, of a folder of "
                "fragility those of its table, which may be of a law. '>': not reached by so "
                "many. The last column "
                "relates medians to the first of the same limit state and stress.";
    t.keys = 3;
    t.head = {"limit state",
              "stress [MPa]",
              "walls of",
              "drifts from",
              "n",
              {"16 % drift [%]", kInterval | kCensored},
              {"median drift [%]", kInterval | kCensored},
              {"84 % drift [%]", kInterval | kCensored},
              "median to the first [%]"};
    for (const ComparedLimit* c : in_order(all)) {
        const double base = first_of(all, *c).drifts[kMedian].value,
                     own = c->drifts[kMedian].value;
        Row row = {c->state, c->group, c->name, c->from, count(c->walls)};
        for (const std::size_t q : {kMedian - 1, kMedian, kMedian + 1})
            row.emplace_back(c->drifts.at(q));
        row.emplace_back(std::isfinite(own) && base > 0.0
                             ? plain_number(100.0 * (own / base - 1.0), 1)
                             : Number{});
        t.rows.push_back(std::move(row));
    }
    return t;
}

std::string compared_limit_chart(const std::vector<ComparedLimit>& all)
{
    Chart chart;
    if (all.empty()) return line_chart(chart);
    const auto last = std::ranges::find_if(
        all.rbegin(), all.rend(), [&](const auto& c) { return c.name == all.front().name; });
    chart.title = "Share of the walls that have reached " + last->state;
    chart.x_label = "Drift [%]";
    chart.y_label = "Share [%]";
    for (const ComparedLimit& c : all) {
        if (c.state != last->state) continue;
        const std::string group = cell_text(c.group);
        Series line;
        line.name = c.name + (group.empty() ? "" : ", " + group + " MPa");
        line.points = true;
        for (std::size_t q = 0; q < kComparedShares.size(); ++q)
            if (std::isfinite(c.drifts.at(q).value)) {
                line.x.push_back(c.drifts.at(q).value);
                line.y.push_back(100.0 * kComparedShares.at(q));
            }
        if (!line.x.empty()) chart.series.push_back(std::move(line));
    }
    return line_chart(chart);
}

} // namespace app
