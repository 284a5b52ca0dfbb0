#include "app/report/report_parts.hpp"

#include "app/input/wall/built_wall.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/mode_share.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/stored/turned_walls.hpp"
#include "app/text/number_text.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
    std::ranges::replace(key, '_', ' ');
    std::ranges::replace(key, '.', ' ');
    return key;
}

std::string listed_keys(const StudyWalls& study)
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

std::string way_text(const PushWay& way)
{
    return (way.direction == 0 ? " in cycles of at most " : " up to ") +
           number(1e3 * way.farthest, 4) + " mm";
}

/// "in 10 courses", "of 15 blocks drawn in portal.dxf"
std::string bond_text(Masonry masonry)
{
    const GeometryInput& g = masonry.geometry;
    grow_rubble(masonry); // a study that is read has not grown it
    if (g.rubble) return "of " + count_of(g.units.size(), "stone") + " of rubble";
    if (!is_drawn(g))
        return "in " + count_of(static_cast<std::size_t>(masonry.wall.courses), "course");
    return "of " + count_of(g.units.size(), "block") + " drawn" +
           (g.file.empty() ? "" : " in " + g.file);
}

std::string wall_text(const Masonry& masonry, const LoadInput& load)
{
    return "a wall of " + fixed(wall_length(masonry), 2) + " m × " +
           fixed(wall_height(masonry), 2) + " m × " + fixed(masonry.wall.thickness, 2) + " m " +
           bond_text(masonry) + ", pushed sideways at a height of " + fixed(load.height, 2) +
           " m" + way_text(push_way(load));
}

std::vector<std::string> what_was_run(const StudyWalls& study)
{
    const std::size_t levels = study.levels.size();
    std::size_t walls = 0;
    for (const StudyLevel& l : study.levels) walls += l.walls.size() + l.failed_walls.size();
    std::string first =
        count_of(walls, "wall") + " under " +
        (levels == 1 ? "one vertical stress" : std::to_string(levels) + " vertical stresses");
    first += levels > 1 ? " from " + stress_text(study.levels.front().stress) + " to " +
                              stress_text(study.levels.back().stress)
                        : ", " + stress_text(study.levels.front().stress);
    first += ": " + wall_text(study.study, study.study.load);
    std::vector<std::string> text = {first + "."};
    if (has_layouts(study.study.geometry))
        text.push_back("The stones lie in " + std::to_string(study.study.geometry.layouts) +
                       " random layouts, those of wall.seed = " +
                       std::to_string(layout_seed(study.study, 0)) +
                       " and so on, which the samples take in turn.");
    if (!study.inputs.empty())
        text.push_back("Drawn at random: " + listed_keys(study) +
                       ". All other values are the same for every wall under one stress.");
    else if (!has_layouts(study.study.geometry))
        text.push_back("Nothing was drawn at random.");
    return text;
}

struct LevelMeans {
    double peak = 0.0, rocking = 0.0, came_down = 0.0; ///< [kN] [-] [-]
};

LevelMeans means_of(const std::vector<StudyWall>& walls)
{
    LevelMeans m;
    for (const StudyWall& w : walls) {
        m.peak += 1e-3 * peak_force(w.reading);
        m.rocking += w.reading.mode == dem::FailureMode::rocking ? 1.0 : 0.0;
        m.came_down += is_observed(w.reading.ultimate) ? 1.0 : 0.0;
    }
    const auto n = static_cast<double>(walls.size());
    return {m.peak / n, m.rocking / n, m.came_down / n};
}

/// "lost 20 % of their peak force"
std::string lost_text(const FragilityInput& f)
{
    return "lost " + percent_text(1.0 - f.ultimate_share) + " of their peak force";
}

/// Lowest and highest stress side by side; empty where one of them has few walls.
std::string in_short(const StudyWalls& study)
{
    const auto [low, high] =
        std::ranges::minmax_element(study.levels, [](const StudyLevel& a, const StudyLevel& b) {
            return a.stress < b.stress;
        });
    constexpr std::size_t kFewest = 5; // shares of fewer say nothing
    if (low == high || low->walls.size() < kFewest || high->walls.size() < kFewest) return {};
    const LevelMeans a = means_of(low->walls), b = means_of(high->walls);
    if (!std::isfinite(a.peak) || !std::isfinite(b.peak)) return {};
    const auto change = [](const std::string& from, const std::string& to) {
        return from == to ? " stays at " + to : " goes from " + from + " to " + to;
    };
    return "From " + stress_text(low->stress) + " to " + stress_text(high->stress) +
           ", the mean peak force" + change(fixed(a.peak, 1), fixed(b.peak, 1)) +
           " kN, the share of walls that rocked" +
           change(percent(a.rocking), percent(b.rocking)) + " %, and the share that " +
           lost_text(study.study.fragility) + " before the push ended" +
           change(percent(a.came_down), percent(b.came_down)) + " %.";
}

std::string level_text(const FragilityInput& f, const StudyLevel& level)
{
    const auto& walls = level.walls;
    if (walls.empty()) return stress_text(level.stress) + ": no wall gave a result.";
    std::vector<double> peaks;
    double sliding = 0.0;
    std::size_t came_down = 0, known = 0, slid = 0;
    for (const StudyWall& w : walls) {
        const WallReading& r = w.reading;
        known += is_defined(r.ultimate) ? 1 : 0;
        if (r.peak) peaks.push_back(r.peak->force * 1e-3);
        sliding += r.mode == dem::FailureMode::sliding ? 1.0 : 0.0;
        slid += r.slid ? 1 : 0;
        came_down += is_observed(r.ultimate) ? 1 : 0;
    }
    std::string text = stress_text(level.stress) + ": ";
    if (peaks.size() >= 2) {
        const uq::Estimate e = uq::estimate_mean(peaks, f.confidence);
        text += "mean peak force " + fixed(e.value, 1) + " kN [" + fixed(e.interval.lower, 1) +
                ", " + fixed(e.interval.upper, 1) + "], single walls between " +
                fixed(*std::ranges::min_element(peaks), 1) + " and " +
                fixed(*std::ranges::max_element(peaks), 1) + " kN; ";
    } else if (!peaks.empty()) {
        text += "peak force " + fixed(peaks.front(), 1) + " kN; ";
    }
    const fragility::Share s = mode_share(level, kRocking, f.confidence);
    return text + percent(s.value) + " % rocked [" + percent(s.interval.lower) + ", " +
           percent(s.interval.upper) + "]" +
           (sliding > 0.0
                ? ", " + percent(sliding / static_cast<double>(walls.size())) + " % slid"
                : "") +
           (slid > 0 ? ", counting " + std::to_string(slid) + " that slid whole" : "") +
           (known == 0 ? "."
                       : "; " + std::to_string(came_down) + " of " + std::to_string(known) +
                             " " + lost_text(f) + " before the push ended.");
}

/// "2 walls failed: ... (0.75 MPa sample 17, ...)" for each reason.
void add_failures(const StudyWalls& study, std::vector<std::string>& text)
{
    constexpr std::size_t kNamed = 12;
    std::size_t missing = 0;
    for (const StudyLevel& level : study.levels) missing += level.missing;
    const auto why = failures(study);
    if (why.empty()) text.push_back("No wall failed.");
    for (const auto& [reason, walls] : why) {
        std::string line = count_of(walls.size(), "wall") + " failed: " + reason + " (" +
                           named(study, walls, kNamed);
        line += walls.size() > kNamed ? ", and more in the table of walls)" : ")";
        text.push_back(line + ". They enter no mean; the bounds of shares allow any mode for "
                              "them.");
    }
    if (missing > 0)
        text.push_back(count_of(missing, "wall") + " of the study " +
                       (missing == 1 ? "is" : "are") +
                       " not in the file: the study is not finished, or the file is a shard.");
}

std::vector<std::string> how_sure(const StudyWalls& study)
{
    std::vector<std::string> text;
    add_failures(study, text);
    std::size_t censored = 0, sound = 0;
    for (const StudyLevel& level : study.levels) {
        sound += level.walls.size();
        for (const StudyWall& w : level.walls) censored += is_censored(w.reading.ultimate);
    }
    if (censored > 0) {
        const std::string none = no_limit_remark(study);
        text.push_back((!none.empty()
                            ? none
                            : std::to_string(censored) + " of " + count_of(sound, "wall") +
                                  " still carried more than " +
                                  percent_text(study.study.fragility.ultimate_share) +
                                  " of the peak at the end.") +
                       " The ultimate displacement of such a wall is only known to be larger "
                       "(censored): the fits count it so, and the means leave it out.");
    }
    for (const std::string& remark :
         {no_yield_remark(study), other_way_remark(study), pier_sentence(study)})
        if (!remark.empty()) text.push_back(remark);
    text.push_back("Brackets are " + percent_text(study.study.fragility.confidence) +
                   " confidence intervals. They reflect the number of walls, not errors of "
                   "the model.");
    return text;
}

} // namespace

Overview overview(const StudyWalls& study)
{
    Overview o;
    o.run = what_was_run(study);
    const FragilityInput& f = study.study.fragility;
    for (const StudyLevel& level : study.levels) o.found.push_back(level_text(f, level));
    o.lead = in_short(study);
    if (o.lead.empty() && !o.found.empty()) o.lead = o.found.front();
    if (o.found.size() == 1) o.found.clear(); // the lead says it
    o.found.push_back("How a wall failed: " + mode_rule_text(f) + ".");
    if (!study.pushed_one_way)
        o.found.push_back(backbone_text(study.study.load, study.study.fragility).substr(1));
    o.sure = how_sure(study);
    return o;
}

} // namespace app
