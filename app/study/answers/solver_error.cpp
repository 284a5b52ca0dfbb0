#include "app/study/answers/solver_error.hpp"

#include "app/reading/wall_numbers.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/words.hpp"
#include "core/sample_quantile.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kUpper = 0.95;
constexpr std::size_t kFewest = 20; ///< walls of which one is 5 %
constexpr std::size_t kNamedWalls = 5;

void append_errors(std::vector<double>& all, const std::vector<double>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

WallErrors all_errors(const StudyWalls& walls, double StudyWall::*error)
{
    WallErrors all;
    for (const StudyLevel& level : walls.levels) {
        const WallErrors e = wall_errors(level, error, walls.study.solver);
        append_errors(all.known, e.known);
        all.unknown += e.unknown;
        all.above.insert(all.above.end(), e.above.begin(), e.above.end());
    }
    std::ranges::sort(all.known);
    return all;
}

AuditDifferences all_differences(const StudyWalls& walls)
{
    AuditDifferences all;
    for (const StudyLevel& level : walls.levels) {
        const AuditDifferences d = audit_differences(level);
        all.checked += d.checked;
        all.failed += d.failed;
        all.missing += d.missing;
        append_errors(all.peak, d.peak);
        append_errors(all.ultimate, d.ultimate);
        all.fell_once += d.fell_once;
        all.other_modes += d.other_modes;
    }
    std::ranges::sort(all.peak);
    std::ranges::sort(all.ultimate);
    return all;
}

/// "95 % of walls below 0.6 %", of few walls "at most 0.6 %"
std::string upper_words(const std::vector<double>& sorted)
{
    return (sorted.size() < kFewest ? "at most " : "95 % of walls below ") +
           error_text(upper_error(sorted));
}

/// "Solver error: median 0.1 %, ..."
/// @param e with known ones
std::string estimated_text(const StudyWalls& walls, const std::string& what,
                           const WallErrors& e)
{
    const std::size_t n = e.known.size() + e.unknown;
    std::string text = what + ": median " + error_text(median_error(e.known)) + ", " +
                       upper_words(e.known) + ", " +
                       (e.above.empty() ? "none" : std::to_string(e.above.size())) + " of " +
                       counted(n, "wall", "walls") + " above the " +
                       error_text(walls.study.solver.accuracy) + " asked for";
    if (!e.above.empty())
        text += " (" + named(walls, e.above, kNamedWalls) +
                (e.above.size() > kNamedWalls ? ", ...)" : ")");
    if (e.unknown > 0) text += ", not known of " + std::to_string(e.unknown);
    return text + ".";
}

std::string speed_text(const StudyWalls& walls)
{
    const WallErrors e = all_errors(walls, &StudyWall::solver_error);
    if (!e.known.empty()) return estimated_text(walls, "Solver error", e);
    if (e.unknown == 0) return {};
    return "Solver error: not known, because the walls were pushed by an earlier version of "
           "the program.";
}

/// "It leaves an error in the displacement at 80 % of the peak: median 2 %, ..."; empty
/// where none is known.
std::string fall_text(const StudyWalls& walls)
{
    std::vector<double> errors;
    std::size_t beyond = 0;
    for (const StudyLevel& level : walls.levels)
        for (const StudyWall& w : level.walls) {
            const double error = ultimate_error(first_way(w));
            if (!std::isfinite(error)) continue;
            errors.push_back(error);
            beyond += ends_in_range(first_way(w)) ? 1 : 0;
        }
    if (errors.empty()) return {};
    std::ranges::sort(errors);
    return "It leaves an error in the displacement at " +
           percent_text(walls.study.fragility.ultimate_share) + " of the peak: median " +
           error_text(median_error(errors)) + ", " + upper_words(errors) +
           (beyond > 0 ? "; the range of " + counted(beyond, "wall", "walls") +
                             " goes on beyond the end of the push"
                       : "") +
           ".";
}

std::string points_text(const StudyWalls& walls)
{
    const WallErrors e = all_errors(walls, &StudyWall::points_error);
    if (e.known.empty()) return {};
    return estimated_text(walls, "Error by the number of contact points", e) +
           (e.above.empty() ? "" : " A larger solver.contact_points lessens it.");
}

std::string audit_text(const StudyWalls& walls)
{
    const AuditDifferences d = all_differences(walls);
    const std::size_t all = d.checked + d.failed + d.missing;
    if (all == 0) return {};
    std::size_t n = 0;
    for (const StudyLevel& level : walls.levels)
        n += level.walls.size() + level.failed_walls.size();
    std::string text = "Solver error of this study, " + std::to_string(d.checked) + " of " +
                       counted(n, "wall", "walls") + " pushed again " +
                       std::to_string(walls.head.levels.back().slower) + " times slower: ";
    if (d.checked == 0)
        text += "nothing is known yet";
    else
        text += "median " + error_text(median_error(d.peak)) + ", " + upper_words(d.peak) +
                " in peaks" +
                (d.ultimate.empty()
                     ? std::string()
                     : ", " + upper_words(d.ultimate) + " in the displacement at " +
                           percent_text(walls.study.fragility.ultimate_share) +
                           " of the peak (" + std::to_string(d.ultimate.size()) + ")");
    if (d.fell_once > 0)
        text += "; the force of " + counted(d.fell_once, "wall", "walls") +
                " came down in one of the two pushes only";
    if (d.other_modes > 0)
        text += "; " + counted(d.other_modes, "wall", "walls") + " failed in another mode";
    if (d.failed > 0)
        text += "; " + std::to_string(d.failed) + " gave no result in one of both";
    if (d.missing > 0) text += "; " + std::to_string(d.missing) + " still to run";
    return text + ".";
}

} // namespace

WallErrors wall_errors(const StudyLevel& level, double StudyWall::*error,
                       const dem::SolverOptions& solver)
{
    WallErrors e;
    for (const StudyWall& w : level.walls) {
        if (std::isfinite(w.*error))
            e.known.push_back(w.*error);
        else
            ++e.unknown;
        if (misses_accuracy(w.*error, solver)) e.above.push_back(w.key);
    }
    std::ranges::sort(e.known);
    return e;
}

AuditDifference audit_difference(const StudyLevel& level, const StudyWall& slow)
{
    AuditDifference d;
    const auto own = std::ranges::lower_bound(level.walls, slow.key, {}, &StudyWall::key);
    if (slow.failed || own == level.walls.end() || own->key != slow.key) return d;
    d.checked = true;
    const WallReading &a = first_way(*own), &b = slow.reading;
    const auto difference = [](double x, double y) {
        return y > 0.0 ? std::abs(x / y - 1.0) : kUnknownError;
    };
    if (a.peak && b.peak) d.peak = difference(a.peak->force, b.peak->force);
    const bool fell = is_observed(a.ultimate);
    d.fell_once = fell != is_observed(b.ultimate);
    if (fell && !d.fell_once)
        d.ultimate = difference(a.ultimate.displacement, b.ultimate.displacement);
    d.other_mode = a.mode != b.mode;
    return d;
}

AuditDifferences audit_differences(const StudyLevel& level)
{
    AuditDifferences all;
    all.missing = level.audit_missing;
    for (const StudyWall& slow : level.audit) {
        const AuditDifference d = audit_difference(level, slow);
        ++(d.checked ? all.checked : all.failed);
        if (std::isfinite(d.peak)) all.peak.push_back(d.peak);
        if (std::isfinite(d.ultimate)) all.ultimate.push_back(d.ultimate);
        all.fell_once += d.fell_once ? 1 : 0;
        all.other_modes += d.other_mode ? 1 : 0;
    }
    std::ranges::sort(all.peak);
    std::ranges::sort(all.ultimate);
    return all;
}

double upper_error(const std::vector<double>& sorted)
{
    if (sorted.empty()) return kUnknownError;
    return sorted.size() < kFewest ? sorted.back() : core::sample_quantile(sorted, kUpper);
}

double median_error(const std::vector<double>& sorted)
{
    return sorted.empty() ? kUnknownError : core::sample_quantile(sorted, 0.5);
}

std::string solver_error_text(const StudyWalls& walls)
{
    std::string text;
    for (const std::string& sentence :
         {speed_text(walls), fall_text(walls), points_text(walls), audit_text(walls)})
        if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
    return text;
}

} // namespace app
