#include "app/push/hand_checks.hpp"

#include "app/input/wall_geometry.hpp"
#include "app/study/pier_remark.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/rigid_wall.hpp"
#include "dem/scene/snapshot_reading.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace app {
namespace {

constexpr double kBeyond = 1.01; ///< of a limit, from which a result is remarked upon [-]

void add_beyond(const char* what, double peak, double limit, std::vector<std::string>& remarks)
{
    if (!(peak > kBeyond * limit)) return;
    const std::string by =
        limit > 0.0 ? fixed(100.0 * (peak / limit - 1.0), 1) + " % above" : "above";
    remarks.push_back("the peak force is " + by + " the limit of " + what +
                      ": the push was too fast (raise solver.steps_per_mm), or the limit does "
                      "not hold for this wall");
}

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
    if (const auto joint = dem::slid_joint(w.result.at_end, kFar))
        remarks.push_back(
            "at the end of the push a joint that is " + fixed(1e3 * joint->length, 0) +
            " mm long has slid by " + fixed(1e3 * joint->slip, 0) +
            " mm, and with small displacements it keeps all of its contact; write "
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
            "the force rises by " + fixed(100.0 * rise, 0) +
            " % of its peak between the last two points before it, so the true peak may be "
            "higher; write a smaller output.record_every");
}

/// A wall that is drawn, has openings, or is bonded by mortar, has no closed form here: its loads alone.
HandChecks loads_alone(const Study& study, const PushedWall& w, const dem::Layout& layout)
{
    const dem::Weights weights =
        dem::weights_of(layout, study.parameters.stone, study.beam.material, w.loads.gravity);
    HandChecks h;
    h.vertical_load = weights.beam;
    h.wall_weight = weights.free; // the floor carries the rest
    if (study.beam.present)
        h.vertical_load += w.vertical_stress * layout.length * layout.thickness;
    return h;
}

HandChecks limits_of(const Study& study, const PushedWall& w)
{
    const Parameters& p = study.parameters;
    dem::Loads loads = w.loads;
    loads.vertical_stress = w.vertical_stress;
    const dem::RigidWall rigid =
        dem::rigid_wall(study.wall, study.beam, p.stone, loads,
                        {std::tan(p.joint.friction_angle), std::tan(p.base_friction_angle),
                         std::tan(p.beam_friction_angle)},
                        w.result.weight);
    HandChecks h;
    h.vertical_load = rigid.vertical_load;
    h.wall_weight = rigid.weight;
    h.rocking_limit = rigid.rocking_limit;
    const bool drawn = std::ranges::any_of(study.random, [](const RandomInput& r) {
        return r.key == "joint.friction_angle" || r.key == "base.friction_angle" ||
               r.key == "beam.friction_angle";
    });
    if (!drawn && std::isfinite(rigid.sliding_limit)) h.sliding_limit = rigid.sliding_limit;
    if (rigid.turning == 0)
        h.remarks.emplace_back(
            study.beam.present
                ? "a single course on a fixed base: no joint can open or slide below "
                  "the beam; only cracks and crushing can end the wall"
                : "a single course on a fixed base: nothing can move");
    const double peak = peak_force(w.reading);
    const bool free_beam = study.beam.rotation == dem::BeamRotation::free;
    if (free_beam && rigid.turning > 0)
        add_beyond("rigid rocking", peak, *h.rocking_limit, h.remarks);
    if (h.sliding_limit && rigid.turning > 0)
        add_beyond("sliding", peak, *h.sliding_limit, h.remarks);
    if (!free_beam)
        h.remarks.emplace_back(
            "the beam does not turn: the rocking limit is that of a beam that turns; "
            "up to twice as much can be carried");
    return h;
}

} // namespace

HandChecks hand_checks(const Study& study, const PushedWall& w)
{
    const dem::Layout layout = layout_of(study);
    const bool closed_form = layout.coursed && !layout.mortar && study.wall.openings.empty();
    HandChecks h = closed_form ? limits_of(study, w) : loads_alone(study, w, layout);
    if (!dem::failed(w.result.outcome))
        h.toe_stress = dem::toe_stress(w.result.at_end, study.wall.base);
    add_missing_limit(study, w, h.remarks);
    if (std::string piers = pier_remark(study); !piers.empty())
        h.remarks.push_back(std::move(piers));
    add_coarse_peak(w, h.remarks);
    add_slid_off(study, w, h.remarks);
    add_unsettled(w, h.remarks);
    return h;
}

} // namespace app
