#include "bench/accuracy/accuracy_tables.hpp"

#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace bench {

namespace {

using Scenes = std::vector<ComparedScene>;

app::Number number(double x, int decimals)
{
    app::Number n;
    n.value = x;
    n.decimals = decimals;
    return n;
}

app::Cell maybe(const std::optional<double>& x, double scale, int decimals)
{
    if (!x) return {};
    return number(scale * *x, decimals);
}

app::Cell share(std::size_t part, std::size_t whole)
{
    if (whole == 0) return {};
    return number(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1);
}

std::vector<app::Head> scene_head()
{
    return {"scene",
            "wall",
            "load",
            "kinematics",
            "fidelity",
            "extras",
            "k_n [Pa/m]",
            "N [kN]",
            "F/N",
            "peak [kN]",
            "reference [kN]",
            "error [%]",
            "reported [%]",
            "fall [mm]",
            "reference [mm]",
            "fall error [%]",
            "outcome",
            "reference outcome",
            "steps",
            "reference steps",
            "seconds",
            "reference seconds",
            "energy residual [%]",
            "remark"};
}

} // namespace

app::Table scene_table(const Scenes& scenes)
{
    app::Table t;
    t.head = scene_head();
    for (const ComparedScene& c : scenes)
        t.rows.push_back({number(static_cast<double>(c.scene.number), 0),
                          c.scene.kind,
                          c.scene.load,
                          c.kinematics,
                          c.fidelity,
                          c.scene.extras,
                          app::Number{app::rounded(c.facts.kn, 4)},
                          number(1e-3 * c.facts.vertical_load, 3),
                          maybe(c.reference.peak, 1.0 / c.facts.vertical_load, 4),
                          maybe(c.asked.peak, 1e-3, 4),
                          maybe(c.reference.peak, 1e-3, 4),
                          maybe(peak_error(c), 100.0, 3),
                          number(100.0 * c.asked.solver_error, 3),
                          maybe(c.asked.drop, 1e3, 4),
                          maybe(c.reference.drop, 1e3, 4),
                          maybe(drop_error(c), 100.0, 3),
                          c.asked.outcome,
                          c.reference.outcome,
                          number(static_cast<double>(c.asked.steps), 0),
                          number(static_cast<double>(c.reference.steps), 0),
                          number(c.asked.seconds, 3),
                          number(c.reference.seconds, 2),
                          number(100.0 * c.asked.residual, 4),
                          remark_on(c)});
    return t;
}

namespace {

/// Sums of a group of scenes that have a reference.
struct GroupSums {
    std::vector<double> errors; ///< of the peak, without sign [%]
    std::size_t scenes = 0, lost = 0, within_1 = 0, within_3 = 0, held = 0;
    std::size_t falls = 0, branches = 0, near = 0, ranges = 0, falls_held = 0;
    double seconds = 0.0, steps = 0.0;

    void add(const ComparedScene& c)
    {
        ++scenes;
        seconds += c.asked.seconds;
        steps += static_cast<double>(c.asked.steps);
        lost += is_lost(c);
        const std::optional<double> error = peak_error(c), drop = drop_error(c);
        if (!error) return;
        errors.push_back(100.0 * std::abs(*error));
        within_1 += std::abs(*error) <= 0.01;
        within_3 += std::abs(*error) <= 0.03;
        held += is_held(c);
        branches += is_branch(c);
        falls += drop || is_branch(c);
        near += drop && std::abs(*drop) <= 0.02;
        ranges += c.asked.earliest.has_value();
        falls_held += (drop || is_branch(c)) && is_drop_held(c);
    }
};

app::Row error_row(const std::string& group, const std::string& what, const Scenes& all,
                   const std::function<bool(const ComparedScene&)>& belongs)
{
    GroupSums s;
    for (const ComparedScene& c : all)
        if (has_reference(c) && belongs(c)) s.add(c);
    app::Row row = {group, what, number(static_cast<double>(s.scenes), 0),
                    number(static_cast<double>(s.lost), 0)};
    for (const double p : {0.5, 0.84, 0.95, 0.99, 1.0})
        row.push_back(number(quantile_of(s.errors, p), 3));
    const std::size_t counted = s.errors.size() + s.lost;
    row.push_back(share(s.within_1, counted));
    row.push_back(share(s.within_3, counted));
    row.push_back(share(s.held, s.errors.size()));
    row.push_back(number(static_cast<double>(s.falls), 0));
    row.push_back(share(s.near, s.falls));
    row.push_back(share(s.falls_held, s.ranges > 0 ? s.falls : 0)); // earlier ones had none
    row.push_back(number(static_cast<double>(s.branches), 0));
    row.push_back(number(1e-6 * s.steps, 2));
    row.push_back(number(s.seconds, 1));
    return row;
}

using Label = std::function<std::string(const ComparedScene&)>;

std::string decades(double kn)
{
    const int low = std::clamp(static_cast<int>(std::floor(std::log10(kn) / 2.0)) * 2, 8, 14);
    return "1e" + std::to_string(low) + " to 1e" + std::to_string(low + 2) + " Pa/m";
}

std::vector<app::Head> error_head()
{
    return {"by",
            "of",
            "scenes",
            "lost",
            "median [%]",
            "84 % [%]",
            "95 % [%]",
            "99 % [%]",
            "largest [%]",
            "within 1 % [%]",
            "within 3 % [%]",
            "error reported [%]",
            "falls",
            "falls within 2 % [%]",
            "fall reported [%]",
            "branches",
            "steps [10^6]",
            "seconds"};
}

/// By what scenes are grouped, and the group of a scene.
std::vector<std::pair<std::string, Label>> groupings()
{
    return {{"wall", [](const ComparedScene& c) { return c.scene.kind; }},
            {"load", [](const ComparedScene& c) { return c.scene.load; }},
            {"kinematics", [](const ComparedScene& c) { return c.kinematics; }},
            {"fidelity", [](const ComparedScene& c) { return c.fidelity; }},
            {"extras",
             [](const ComparedScene& c) {
                 return c.scene.extras.empty() ? std::string("none") : std::string("some");
             }},
            {"k_n", [](const ComparedScene& c) { return decades(c.facts.kn); }},
            {"end", [](const ComparedScene& c) {
                 return std::string(c.asked.outcome == c.reference.outcome ? "as the reference"
                                                                           : "otherwise");
             }}};
}

} // namespace

app::Table error_table(const Scenes& scenes)
{
    app::Table t;
    t.head = error_head();
    t.keys = 2;
    t.rows.push_back(error_row("all", "", scenes, [](const ComparedScene&) { return true; }));
    for (const std::pair<std::string, Label>& grouping : groupings()) {
        const Label& label = grouping.second; // a structured binding cannot be captured
        std::set<std::string> names;
        for (const ComparedScene& c : scenes) names.insert(label(c));
        for (const std::string& one : names)
            t.rows.push_back(
                error_row(grouping.first, one, scenes,
                          [&](const ComparedScene& c) { return label(c) == one; }));
    }
    for (const std::string extra :
         {"mortar", "crushing", "cracks at mid", "cracks in patterns"})
        t.rows.push_back(error_row("with", extra, scenes, [&](const ComparedScene& c) {
            return c.scene.extras.find(extra) != std::string::npos;
        }));
    return t;
}

app::Table worst_table(const Scenes& scenes)
{
    Scenes worst;
    for (const ComparedScene& c : scenes)
        if (peak_error(c)) worst.push_back(c);
    const auto error = [](const ComparedScene& c) { return std::abs(*peak_error(c)); };
    std::ranges::stable_sort(worst, std::greater{}, error);
    constexpr std::size_t kShown = 10;
    if (worst.size() > kShown) worst.resize(kShown);
    app::Table t;
    t.head = {"scene",          "wall",      "load",        "kinematics",
              "fidelity",       "extras",    "k_n [Pa/m]",  "peak [kN]",
              "reference [kN]", "error [%]", "reported [%]"};
    for (const ComparedScene& c : worst)
        t.rows.push_back({number(static_cast<double>(c.scene.number), 0), c.scene.kind,
                          c.scene.load, c.kinematics, c.fidelity, c.scene.extras,
                          app::number(c.facts.kn, 3), maybe(c.asked.peak, 1e-3, 3),
                          maybe(c.reference.peak, 1e-3, 3), maybe(peak_error(c), 100.0, 2),
                          number(100.0 * c.asked.solver_error, 2)});
    return t;
}

app::Table apart_table(const Scenes& scenes)
{
    std::map<std::string, std::string> named;
    std::map<std::string, int> counts;
    for (const ComparedScene& c : scenes) {
        const std::string why = remark_on(c);
        if (why.empty()) continue;
        ++counts[why];
        std::string& list = named[why];
        list += (list.empty() ? "" : ", ") + std::to_string(c.scene.number);
    }
    app::Table t;
    t.head = {"remark", "count", "scenes"};
    for (const auto& [why, count] : counts)
        t.rows.push_back({why, number(count, 0), named[why]});
    return t;
}

} // namespace bench
