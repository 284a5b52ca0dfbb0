#include "app/report/report_overview.hpp"

#include "app/input/number_text.hpp"
#include "app/study/mode_rule.hpp"
#include "fragility/binomial.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace app {
namespace {

std::string count_of(std::size_t n, const std::string& one)
{
    return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

std::string percent(double share) { return fixed(100.0 * share, 0); }

/// "joint.friction_angle" as words.
std::string words_of(std::string key)
{
    std::replace(key.begin(), key.end(), '_', ' ');
    std::replace(key.begin(), key.end(), '.', ' ');
    return key;
}

std::string listed_keys(const ReportStudy& study)
{
    std::string text;
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        const StoredInput& input = study.inputs[i];
        if (i > 0) text += i + 1 == study.inputs.size() ? " and " : ", ";
        text += words_of(input.key);
        if (input.count > 1) text += " (one value per joint)";
    }
    return text;
}

/// Where the push goes; targets [m].
std::string way_text(const std::vector<double>& targets)
{
    const auto [low, high] = std::minmax_element(targets.begin(), targets.end());
    const std::string farthest = number(1e3 * std::max(std::abs(*low), std::abs(*high)), 4);
    if (*low < 0.0 && *high > 0.0) return " to and fro, at most " + farthest + " mm";
    return " up to " + farthest + " mm";
}

std::string wall_text(const Study& study)
{
    const double height = study.wall.courses * study.wall.course_height;
    return "a wall of " + fixed(study.wall.length, 2) + " m × " + fixed(height, 2) + " m × " +
           fixed(study.wall.thickness, 2) + " m in " +
           count_of(static_cast<std::size_t>(study.wall.courses), "course") +
           ", pushed sideways at a height of " + fixed(study.load.height, 2) + " m" +
           way_text(push_plan(study).targets);
}

std::vector<std::string> what_was_run(const ReportStudy& study)
{
    const std::size_t levels = study.head.levels.size();
    std::string first =
        count_of(study.walls.size(), "wall") + " under " +
        (levels == 1 ? "one vertical stress" : std::to_string(levels) + " vertical stresses");
    first += levels > 1
                 ? " from " + study.stress_text(0) + " to " + study.stress_text(levels - 1)
                 : ", " + study.stress_text(0);
    if (study.study) first += ": " + wall_text(*study.study);
    std::vector<std::string> text = {first + "."};
    if (!study.inputs.empty())
        text.push_back("Drawn at random: " + listed_keys(study) +
                       ". Everything else is the "
                       "same in all walls of a stress.");
    else
        text.push_back("Nothing was drawn at random.");
    return text;
}

struct LevelMeans {
    double peak = 0.0, rocking = 0.0, came_down = 0.0; ///< [kN] [-] [-]
};

LevelMeans means_of(const std::vector<const ReportWall*>& walls)
{
    LevelMeans m;
    for (const ReportWall* w : walls) {
        m.peak += 1e-3 * w->peak;
        m.rocking += w->rocking ? 1.0 : 0.0;
        m.came_down += w->reading == fragility::Reading::observed ? 1.0 : 0.0;
    }
    const auto n = static_cast<double>(walls.size());
    return {m.peak / n, m.rocking / n, m.came_down / n};
}

/// Lowest and highest stress side by side; nothing where one of them has few walls.
std::vector<std::string> in_short(const ReportStudy& study)
{
    const std::size_t levels = study.head.levels.size();
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < levels; ++i) {
        if (study.stress(i) < study.stress(low)) low = i;
        if (study.stress(i) > study.stress(high)) high = i;
    }
    constexpr std::size_t kFewest = 5; // shares of fewer say nothing
    if (low == high || study.sound(low).size() < kFewest || study.sound(high).size() < kFewest)
        return {};
    const LevelMeans a = means_of(study.sound(low)), b = means_of(study.sound(high));
    if (!std::isfinite(a.peak) || !std::isfinite(b.peak)) return {};
    return {"In short: from " + study.stress_text(low) + " to " + study.stress_text(high) +
            ", the mean peak force goes from " + fixed(a.peak, 1) + " to " + fixed(b.peak, 1) +
            " kN, the share of walls that rocked from " + percent(a.rocking) + " to " +
            percent(b.rocking) + " %, and the share that lost a fifth of their peak force " +
            "before the push ended from " + percent(a.came_down) + " to " +
            percent(b.came_down) + " %."};
}

std::string level_text(const ReportStudy& study, std::size_t level)
{
    const auto walls = study.sound(level);
    if (walls.empty()) return study.stress_text(level) + ": no wall gave a result.";
    std::vector<double> peaks;
    double rocking = 0.0;
    std::size_t came_down = 0, known = 0, slid = 0;
    for (const ReportWall* w : walls) {
        known += w->reading == fragility::Reading::not_defined ? 0 : 1;
        if (std::isfinite(w->peak)) peaks.push_back(w->peak * 1e-3);
        rocking += w->rocking ? 1.0 : 0.0;
        slid += w->slid ? 1 : 0;
        came_down += w->reading == fragility::Reading::observed ? 1 : 0;
    }
    std::string text = study.stress_text(level) + ": ";
    if (peaks.size() >= 2) {
        const uq::Estimate e = uq::estimate_mean(peaks);
        text += "mean peak force " + fixed(e.value, 1) + " kN [" + fixed(e.interval.lower, 1) +
                ", " + fixed(e.interval.upper, 1) + "], single walls between " +
                fixed(*std::min_element(peaks.begin(), peaks.end()), 1) + " and " +
                fixed(*std::max_element(peaks.begin(), peaks.end()), 1) + " kN; ";
    } else if (!peaks.empty()) {
        text += "peak force " + fixed(peaks.front(), 1) + " kN; ";
    }
    std::size_t failed = 0;
    for (const ReportWall& w : study.walls)
        failed += w.failed && w.row.key.level == level ? 1 : 0;
    const fragility::Share s = fragility::share(rocking, static_cast<double>(walls.size()),
                                                static_cast<double>(failed));
    return text + percent(s.value) + " % rocked [" + percent(s.bounds.lower) + ", " +
           percent(s.bounds.upper) + "]" +
           (slid > 0 ? ", counting " + std::to_string(slid) + " that slid whole" : "") +
           (known == 0 ? "."
                       : "; " + std::to_string(came_down) + " of " + std::to_string(known) +
                             " lost a fifth of their peak before the push ended.");
}

/// "2 walls failed: ... (0.75 MPa sample 17, ...)" for each reason.
void add_failures(const ReportStudy& study, std::vector<std::string>& text)
{
    constexpr std::size_t kNamed = 12;
    std::map<std::string, std::vector<WallKey>> why;
    for (const ReportWall& w : study.walls)
        if (w.failed) why[w.row.reason].push_back(w.row.key);
    if (why.empty()) text.push_back("No wall failed.");
    for (const auto& [reason, walls] : why) {
        std::string line = count_of(walls.size(), "wall") + " failed: " + reason + " (";
        for (std::size_t i = 0; i < std::min(kNamed, walls.size()); ++i)
            line += (i > 0 ? ", " : "") + study.stress_text(walls[i].level) + " sample " +
                    std::to_string(walls[i].sample);
        line += walls.size() > kNamed ? ", and more in the table of walls)" : ")";
        text.push_back(line + ". They are in no mean; shares are given as if each could have "
                              "been of any mode.");
    }
    if (study.missing > 0)
        text.push_back(count_of(study.missing, "wall") + " of the study " +
                       (study.missing == 1 ? "is" : "are") +
                       " not in the file: it is not finished, or a shard.");
}

std::vector<std::string> how_sure(const ReportStudy& study)
{
    std::vector<std::string> text;
    add_failures(study, text);
    std::size_t censored = 0, sound = 0;
    for (const ReportWall& w : study.walls) {
        sound += w.failed ? 0 : 1;
        censored += w.reading == fragility::Reading::censored ? 1 : 0;
    }
    if (censored > 0)
        text.push_back(
            std::to_string(censored) + " of " + count_of(sound, "wall") +
            " still carried more than 80 % of their peak when their push ended. Their "
            "ultimate displacement is only known to be larger (censored): it counts as "
            "that in the fits, and in no mean.");
    text.push_back(
        "In brackets: 95 % intervals, as of independent samples. They hold the chance of "
        "the draw, not the error of the model.");
    return text;
}

} // namespace

Overview overview(const ReportStudy& study)
{
    Overview o;
    o.run = what_was_run(study);
    o.found = in_short(study);
    for (std::size_t level = 0; level < study.head.levels.size(); ++level)
        o.found.push_back(level_text(study, level));
    o.found.push_back("How a wall failed: " + mode_rule_text({}) + ".");
    o.sure = how_sure(study);
    return o;
}

} // namespace app
