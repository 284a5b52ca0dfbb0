#include "app/compare/compared_cycles.hpp"

#include "app/output/table/cells.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

/// Jitter before the first cycle, and between two turns of a path, as a share of the farthest
/// displacement [-]: less than the first cycle of ISO 16670. A free choice.
constexpr double kFirstJitter = 0.01;

double farthest_of(const std::vector<double>& u)
{
    double farthest = 0.0;
    for (const double x : u) farthest = std::max(farthest, std::abs(x));
    return farthest;
}

/// A way to the other side of zero that is shorter than kNoise of the way before it is jitter:
/// its points stay on the side of that way, next to zero.
std::vector<double> without_jitter(std::vector<double> u)
{
    const double farthest = farthest_of(u);
    double before = 0.0; // the farthest of the last way, with its sign
    for (std::size_t i = 0; i < u.size();) {
        double reach = u[i];
        std::size_t end = i + 1;
        for (; end < u.size() && u[end] * reach >= 0.0; ++end)
            if (std::abs(u[end]) > std::abs(reach)) reach = u[end];
        const double least =
            before == 0.0 ? kFirstJitter * farthest : kNoise * std::abs(before);
        const bool jitter = std::abs(reach) < least && reach * before <= 0.0;
        for (; i < end; ++i)
            if (jitter) u[i] = 1e-12 * before;
        if (!jitter && std::abs(reach) > 0.0)
            before =
                reach * before > 0.0 && std::abs(before) > std::abs(reach) ? before : reach;
    }
    return u;
}

/// Displacements at which the path turns back by more than jitter does, and the last one.
std::vector<double> turns_of(const std::vector<double>& u)
{
    const double least = kFirstJitter * farthest_of(u);
    std::vector<double> turns;
    double extreme = u.front();
    int way = 0; // 1: to the right, -1: to the left, 0: not known yet
    for (const double x : u) {
        if (way == 0 && std::abs(x - extreme) > least) way = x > extreme ? 1 : -1;
        if (way * (x - extreme) > 0.0) extreme = x;
        if (way * (extreme - x) <= least) continue;
        turns.push_back(extreme);
        way = -way;
        extreme = x;
    }
    turns.push_back(u.back());
    return turns;
}

Number of(const std::optional<double>& value, double scale, int decimals)
{
    return value ? plain_number(*value * scale, decimals) : Number{};
}

} // namespace

std::vector<fragility::Cycle> compared_cycles(const Compared& c)
{
    return fragility::cycles(
        {c.measured ? without_jitter(c.displacement) : c.displacement, c.force});
}

Table compared_cycle_table(const std::vector<Compared>& all)
{
    Table t;
    t.title = "Cycles side by side";
    t.caption =
        "Each cycle goes from zero displacement to zero. Amplitude: half the distance of its "
        "extremes; of a cycle to one side its extreme. Forces: the largest to the right and to "
        "the left. Energy: the area of its "
        "loop. Damping: equivalent viscous, energy / (2 pi F d), with F d the mean of both "
        "sides. Stiffness: of the line between both extremes.";
    t.keys = 2;
    t.head = {
        "wall",       "cycle",       "amplitude [mm]",   "force right [kN]", "force left [kN]",
        "energy [J]", "damping [%]", "stiffness [kN/mm]"};
    for (const Compared& c : all) {
        if (!goes_to_and_fro(c)) continue;
        int number = 0;
        for (const fragility::Cycle& cycle : compared_cycles(c))
            t.rows.push_back({c.name, count(++number),
                              plain_number(fragility::amplitude(cycle) * 1e3, 2),
                              number_cell(wall_number("peak_force"), cycle.force_plus),
                              number_cell(wall_number("peak_force"), cycle.force_minus),
                              plain_number(cycle.energy, 1),
                              of(fragility::equivalent_damping(cycle), 100.0, 1),
                              of(fragility::secant_stiffness(cycle), 1e-6, 3)});
    }
    return t;
}

std::string targets_along(const Compared& c)
{
    if (!c.measured || !goes_to_and_fro(c)) return "";
    std::string list;
    for (const double u : turns_of(c.displacement))
        list += (list.empty() ? "" : ", ") + number(std::round(u * 1e5) * 1e-2, 6);
    return "load.targets = " + list + " mm";
}

} // namespace app
