#include "app/push/capacity_text.hpp"

#include "app/output/capacity_csv.hpp"

namespace app {
namespace {

BodyForceColumns body_force_columns(const PushedWall& w)
{
    BodyForceColumns columns;
    if (w.loads.pattern != dem::LoadPattern::body) return columns;
    for (const dem::CurvePoint& p : w.result.curve) {
        columns.load_factor.push_back(p.force / w.result.weight);
        columns.corner.push_back(p.corner);
    }
    return columns;
}

} // namespace

std::string capacity_text(const PushedWall& wall)
{
    return capacity_csv(wall.displacement, wall.force, wall.loads.height,
                        body_force_columns(wall));
}

} // namespace app
