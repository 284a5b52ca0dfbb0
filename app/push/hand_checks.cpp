#include "app/push/hand_checks.hpp"

#include "app/input/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/bond.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {
namespace {

constexpr double kBeyond = 1.01; ///< of a limit, from which a result is remarked upon [-]

/// The joints above the ground, or above a first course that is fixed.
bool can_open_first(const Study& study, const dem::FaceState& face, const dem::Snapshot& wall)
{
    if (study.wall.base != dem::Base::fixed) return face.kind == dem::FaceKind::base_joint;
    return face.kind == dem::FaceKind::bed_joint && face.block_a >= 0 &&
           wall.blocks.at(static_cast<std::size_t>(face.block_a)).course == 1;
}

std::optional<double> compression(const Study& study, const dem::Snapshot& wall)
{
    std::optional<double> most;
    for (const dem::FaceState& face : wall.faces)
        if (can_open_first(study, face, wall))
            for (const dem::ContactState& c : face.contacts)
                most = std::max(most.value_or(0.0), -c.sigma);
    return most;
}

std::string beyond(const char* what, double peak, double limit)
{
    return "the peak force is " + fixed(100.0 * (peak / limit - 1.0), 1) +
           " % above the limit of " + what +
           ": the push was too fast (raise solver.steps_per_mm), or the limit does not hold "
           "for this wall";
}

/// A wall that is drawn, has openings, or is bonded by mortar, has no closed form here: its loads and its toe alone.
HandChecks loads_alone(const Study& study, const PushedWall& w, const dem::Layout& layout)
{
    HandChecks h;
    for (std::size_t k = 0; k < layout.blocks.size(); ++k) {
        const dem::Block& b = layout.blocks[k];
        const int block = static_cast<int>(k);
        const bool beam = block == layout.beam;
        if (!beam && b.motion != dem::Motion::free) continue; // the floor carries it
        const dem::Elastic& stone =
            dem::stone_of(layout, block, study.parameters.stone, study.beam.material);
        (beam ? h.vertical_load : h.wall_weight) +=
            stone.density * w.loads.gravity * dem::area_of(b) * layout.thickness;
    }
    if (study.beam.present)
        h.vertical_load += w.vertical_stress * layout.length * layout.thickness;
    if (!dem::failed(w.result.outcome)) h.toe_stress = compression(study, w.result.at_end);
    return h;
}

} // namespace

namespace {

/// Why the push found no drift limit, where the choice of kinematics is the reason.
void add_missing_limit(const Study& study, const PushedWall& w,
                       std::vector<std::string>& remarks)
{
    if (study.solver.kinematics == dem::Kinematics::small && is_censored(w.reading.ultimate))
        remarks.emplace_back(
            "the drift limit was not reached: with small displacements a wall that rocks or "
            "slides keeps its load; for its limit write solver.kinematics = finite and a "
            "larger "
            "load.max_displacement");
}

/// Small displacements leave a joint the contact that it was built with, however far it slides.
void add_slid_off(const Study& study, const PushedWall& w, std::vector<std::string>& remarks)
{
    constexpr double kFar = 0.25; // of its length: a free choice
    if (study.solver.kinematics != dem::Kinematics::small || dem::failed(w.result.outcome))
        return;
    double slid = 0.0, length = 0.0; // [m]
    for (const dem::FaceState& face : w.result.at_end.faces) {
        if (face.contacts.size() < 2) continue;
        const dem::Point from = face.contacts.front().at, to = face.contacts.back().at;
        const double own = std::hypot(to.x - from.x, to.z - from.z);
        for (const dem::ContactState& c : face.contacts)
            if (c.sigma < 0.0 && std::abs(c.slip) > std::max(kFar * own, slid)) {
                slid = std::abs(c.slip);
                length = own;
            }
    }
    if (slid > 0.0)
        remarks.push_back("at the end of the push a joint that is " + fixed(1e3 * length, 0) +
                          " mm long has slid by " + fixed(1e3 * slid, 0) +
                          " mm, and small displacements leave it all of its contact; write "
                          "solver.kinematics = finite");
}

/// The push of such a wall begins while it still moves.
void add_unsettled(const PushedWall& w, std::vector<std::string>& remarks)
{
    if (w.result.settled || dem::failed(w.result.outcome) || came_down_at_once(w)) return;
    remarks.emplace_back(
        "the wall had not come to rest under its vertical load when the push began: it may be "
        "coming down, or write a larger solver.preload_steps");
}

/// A wall of stiff joints may have its peak, and lose it, between two recorded points.
void add_coarse_peak(const PushedWall& w, std::vector<std::string>& remarks)
{
    constexpr double kMostRise = 0.03; // of the peak, which may be as much too low
    const double peak = std::abs(peak_force(w.reading));
    const auto at = std::ranges::max_element(w.force, {}, [](double f) { return std::abs(f); });
    if (w.force.empty() || at == w.force.begin() || !(peak > 0.0)) return;
    const double rise = std::abs(*at - *std::prev(at)) / peak;
    if (rise > kMostRise)
        remarks.push_back(
            "between the last two recorded points before its peak the force rises by " +
            fixed(100.0 * rise, 0) +
            " % of it, and may have been higher between them; write a smaller "
            "output.record_every");
}

HandChecks checks_of(const Study& study, const PushedWall& w)
{
    const dem::Layout layout = layout_of(study);
    if (!layout.coursed || layout.mortar || !study.wall.openings.empty())
        return loads_alone(study, w, layout);
    const dem::WallGeometry& g = study.wall;
    const bool fixed_base = g.base == dem::Base::fixed;
    const int turning = g.courses - (fixed_base ? 1 : 0);
    const double floor = fixed_base ? dem::top_of_course(g, 1) : 0.0; // of what may move [m]
    const double top = dem::top_of_course(g, g.courses), wall_height = top - floor;
    const double weight_per_height =
        study.parameters.stone.density * w.loads.gravity * g.length * g.thickness; // [N/m]
    const double top_course = weight_per_height * (top - dem::top_of_course(g, g.courses - 1));
    const double beam = study.beam.present ? study.beam.material.density * w.loads.gravity *
                                                 g.length * g.thickness * study.beam.height
                                           : 0.0;
    HandChecks h;
    h.vertical_load = w.vertical_stress * g.length * g.thickness + beam;
    h.wall_weight = weight_per_height * wall_height;
    const double restoring = (h.vertical_load + h.wall_weight) * 0.5 * g.length; // [N m]
    const double moving = h.wall_weight + beam; // what body forces push above the floor
    const bool body = w.loads.pattern == dem::LoadPattern::body && moving > 0.0;
    if (body) {
        const double turned =
            0.5 * h.wall_weight * wall_height + beam * (wall_height + 0.5 * study.beam.height);
        h.rocking_limit = restoring / turned * w.result.weight;
    } else {
        h.rocking_limit = restoring / (w.loads.height - floor);
    }
    const bool drawn = std::ranges::any_of(
        study.random, [](const RandomInput& r) { return r.key == "joint.friction_angle"; });
    const double tan_phi = std::tan(study.parameters.joint.friction_angle);
    if (!drawn && body)
        h.sliding_limit =
            tan_phi * (h.vertical_load + h.wall_weight) / moving * w.result.weight;
    else if (!drawn)
        h.sliding_limit = tan_phi * (h.vertical_load + (turning > 0 ? top_course : 0.0));
    if (!dem::failed(w.result.outcome)) h.toe_stress = compression(study, w.result.at_end);

    if (turning == 0)
        h.remarks.emplace_back(
            study.beam.present
                ? "a single course on a fixed base: no joint can open or slide below "
                  "the beam, so that the wall cannot fail"
                : "a single course on a fixed base: nothing can move");
    const double peak = peak_force(w.reading);
    const bool free_beam = study.beam.rotation == dem::BeamRotation::free;
    if (free_beam && turning > 0 && peak > kBeyond * *h.rocking_limit)
        h.remarks.push_back(beyond("rigid rocking", peak, *h.rocking_limit));
    if (h.sliding_limit && turning > 0 && peak > kBeyond * *h.sliding_limit)
        h.remarks.push_back(beyond("sliding", peak, *h.sliding_limit));
    if (!free_beam)
        h.remarks.emplace_back(
            "the beam does not turn: the rocking limit is that of a beam that "
            "does, up to twice as much can be carried");
    return h;
}

} // namespace

HandChecks hand_checks(const Study& study, const PushedWall& w)
{
    HandChecks h = checks_of(study, w);
    add_missing_limit(study, w, h.remarks);
    add_coarse_peak(w, h.remarks);
    add_slid_off(study, w, h.remarks);
    add_unsettled(w, h.remarks);
    return h;
}

} // namespace app
