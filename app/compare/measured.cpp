#include "app/compare/measured.hpp"

#include "app/output/table/cells.hpp"
#include "app/push/test_curve.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace app {
namespace {

/// Farthest displacement of a side, and the sum of the forces on the way out there.
struct WayOut {
    double reach = 0.0, force = 0.0;
};

WayOut way_out(const TestCurve& curve, int side)
{
    WayOut out;
    for (std::size_t i = 0; i < curve.force.size(); ++i)
        if (const double u = side * curve.displacement[i]; u > out.reach)
            out = {u, out.force + side * curve.force[i]};
    return out;
}

/// Load cells that measure the reaction have the other sign.
std::string turn_force(TestCurve& curve)
{
    if (way_out(curve, 1).force + way_out(curve, -1).force >= 0.0) return "";
    for (double& f : curve.force) f = -f;
    return "its forces are against its displacements, as those of a reaction; their signs were "
           "changed";
}

std::string note_of_begin(const TestCurve& curve)
{
    const auto off = [](const std::vector<double>& v) {
        const auto [least, most] = std::ranges::minmax(v);
        return std::abs(v.front()) > kNoise * (most - least);
    };
    if (!off(curve.displacement) && !off(curve.force)) return "";
    return "it begins at " + fixed(curve.displacement.front() * 1e3, 2) + " mm and " +
           fixed(curve.force.front() * 1e-3, 2) +
           " kN; subtract them from its columns if the wall was at rest there";
}

/// Cycles have no single curve, nor has a sensor that jitters: they are read on the envelope of
/// each side that the wall was pushed to.
ReadingRules rules_of(const TestCurve& curve)
{
    const double right = way_out(curve, 1).reach, left = way_out(curve, -1).reach;
    ReadingRules rules;
    rules.direction = left > right ? -1 : 1;
    const auto comes_back = [&](double a, double b) { return (b - a) * rules.direction < 0.0; };
    if (std::ranges::adjacent_find(curve.displacement, comes_back) == curve.displacement.end())
        return rules;
    rules.direction = 0;
    if (left < kNoise * right) rules.backbone = fragility::Side::right;
    if (right < kNoise * left) rules.backbone = fragility::Side::left;
    return rules;
}

/// The stiffness of the side that was loaded first, where the mean of both has none.
double stiffness_of(const WallReading& r)
{
    if (r.stiffness) return *r.stiffness;
    for (const WallReading& side : r.backbones)
        if (side.stiffness) return *side.stiffness;
    return kNoNumber;
}

} // namespace

Compared read_measured(const std::string& path)
{
    TestCurve curve = read_test_curve(path);
    Compared c;
    c.name = curve.name;
    for (const std::string& note : {turn_force(curve), note_of_begin(curve)})
        if (!note.empty()) c.note += (c.note.empty() ? "" : "; ") + note;
    const WallReading r = read({curve.displacement, curve.force}, {}, rules_of(curve), true);
    c.peak = peak_force(r);
    c.cells = {Number{},
               count(1),
               number_cell(wall_number("peak_force"), peak_force(r)),
               number_cell(wall_number("peak_displacement"), peak_displacement(r)),
               number_cell(wall_number("secant_stiffness"), stiffness_of(r)),
               limit_cell(r.ultimate, 1e3, 1),
               Number{},
               std::string("measured")};
    c.measured = true;
    c.displacement = std::move(curve.displacement);
    c.force = std::move(curve.force);
    return c;
}

bool is_measured(const std::string& path)
{
    const std::string ending = lower_case(std::filesystem::path(path).extension().string());
    return ending == ".csv" || ending == ".txt" || ending == ".tsv";
}

} // namespace app
