#include "app/push/capacity_text.hpp"

#include "app/output/capacity_csv.hpp"

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
    const auto energy = [&](const char* name, double dem::Energy::*part) {
        all.push_back(column(w, name, [=](const Point& p) { return p.energy.*part; }));
    };
    energy("work_J", &dem::Energy::work);
    energy("elastic_J", &dem::Energy::elastic);
    energy("friction_J", &dem::Energy::friction);
    energy("fracture_J", &dem::Energy::fracture);
    energy("crushing_J", &dem::Energy::crushing);
    energy("damping_J", &dem::Energy::damping);
    energy("kinetic_J", &dem::Energy::kinetic);
    energy("lifted_J", &dem::Energy::lifted);
    return all;
}

} // namespace

std::string capacity_text(const PushedWall& wall)
{
    return capacity_csv(wall.displacement, wall.force, wall.loads.height, columns_of(wall));
}

} // namespace app
