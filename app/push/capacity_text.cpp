#include "app/push/capacity_text.hpp"

#include "app/output/capacity_csv.hpp"
#include "dem/solver/state/energy_parts.hpp"

#include <utility>

namespace app {
namespace {

template <class Value> CurveColumn column(const PushedWall& w, std::string name, Value value)
{
    CurveColumn c{std::move(name), {}};
    for (const dem::CurvePoint& p : w.result.curve) c.values.push_back(value(p));
    return c;
}

std::vector<CurveColumn> columns_of(const PushedWall& w)
{
    using Point = dem::CurvePoint;
    std::vector<CurveColumn> all;
    if (w.loads.pattern == dem::LoadPattern::body) {
        const double weight = w.result.weight;
        all = {
            column(w, "load_factor", [=](const Point& p) { return p.force / weight; }),
            column(w, "corner_displacement_mm", [](const Point& p) { return p.corner * 1e3; })};
    }
    all.push_back(
        column(w, "base_shear_kN", [](const Point& p) { return p.base_shear * 1e-3; }));
    all.push_back(column(w, "unbalance_kN", [](const Point& p) { return p.unbalance * 1e-3; }));
    for (const dem::EnergyPart& part : dem::kEnergyParts)
        all.push_back(column(w, std::string(part.name) + "_J",
                             [&](const Point& p) { return p.energy.*part.value; }));
    return all;
}

} // namespace

std::string capacity_text(const PushedWall& wall)
{
    return capacity_csv(wall.displacement, wall.force, wall.loads.height, columns_of(wall));
}

} // namespace app
