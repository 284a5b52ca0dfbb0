#include "app/push/hand_checks.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/push/pier_table.hpp"
#include "app/reading/points_error.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/mechanism/rigid_wall.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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
                      ": the push was too fast (write a smaller solver.accuracy), or the limit "
                      "does not hold for this wall");
}

void add(std::string remark, std::vector<std::string>& remarks)
{
    if (!remark.empty()) remarks.push_back(std::move(remark));
}

/// Measured: eight arches and three single blocks, docs/model.md, section 4.
void add_local_drag(const dem::SolverOptions& solver, std::vector<std::string>& remarks)
{
    if (solver.damping != dem::Damping::local) return;
    remarks.emplace_back(
        "solver.damping = local drags blocks that turn, however slow the push: peaks of arches "
        "and of single blocks were 1.3 to 6.4 % above their limit loads where the solver error "
        "said 0.5 to 1.8 %; combined damping does not");
}

/// Small displacements leave a joint the contact that it was built with, however far it slides.
void add_slid_off(const dem::SolverOptions& solver, const PushedWall& w,
                  std::vector<std::string>& remarks)
{
    constexpr double kFar = 0.25; // of its length: a free choice
    if (solver.kinematics != dem::Kinematics::small || dem::failed(w.result.outcome)) return;
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

/// Such a wall stands only if nobody hurries.
void add_slow_start(const PushedWall& w, std::vector<std::string>& remarks)
{
    if (w.result.slow_starts > 0 && w.result.settled)
        remarks.emplace_back(
            "the wall seemed to come down when its vertical load was put on as always, and "
            "came to rest when that took ten times the steps: it may be near its limit");
}

/// A beam that slides on the wall is the limit of the test, not of the wall.
void add_sliding_beam(const dem::Beam& beam, const PushedWall& w,
                      std::vector<std::string>& remarks)
{
    constexpr double kMost = 0.5; // of the displacement: a free choice
    if (beam.interface != dem::BeamInterface::joint || dem::failed(w.result.outcome)) return;
    const dem::Snapshot& out = w.result.at_farthest.value_or(w.result.at_end);
    const double slip = dem::beam_slip(out), pushed = std::abs(out.displacement);
    if (slip > kMost * pushed)
        remarks.push_back(
            "the loading beam slid by " + fixed(1e3 * slip, 1) + " mm on the wall, of " +
            fixed(1e3 * pushed, 1) +
            " mm that it was pushed: this is a limit of the rig, not of the wall; write "
            "beam.interface = tied, or a larger beam.friction_angle");
}

/// Where joints do not crush, a wall turns about a toe that no stone could be.
void add_toe_stress(const Parameters& parameters, const HandChecks& h,
                    std::vector<std::string>& remarks)
{
    constexpr double kRatio =
        10.0; // of strengths in compression and tension of stones: a free choice
    const double tension = parameters.unit.tensile_strength;
    const bool crushes = parameters.joint.crushing.strength > 0.0;
    if (crushes || !h.toe_stress || !(tension > 0.0) || *h.toe_stress <= kRatio * tension)
        return;
    remarks.push_back("the toe carries " + fixed(1e-6 * *h.toe_stress, 1) +
                      " MPa, more than ten times the tensile strength of the units (" +
                      fixed(1e-6 * tension, 1) +
                      " MPa), and its joints do not crush; write joint.compressive_strength");
}

/// A wall that stood under its load and was lost before its curve had a second point.
void add_lost(const PushedWall& w, std::vector<std::string>& remarks)
{
    if (w.result.settled && came_down_at_once(w))
        remarks.emplace_back("the wall stood under its vertical load and was lost as soon as "
                             "it was pushed: it fell, or "
                             "the push is too fast for joints as stiff as these; write a "
                             "smaller solver.accuracy, "
                             "or solver.fidelity = simple");
}

/// The drive was faster than the accuracy allows.
void add_inaccurate(const dem::SolverOptions& solver, const PushedWall& w,
                    std::vector<std::string>& remarks)
{
    if (misses_accuracy(solver_error(w), solver))
        remarks.push_back("the peak force may be wrong by " + error_text(solver_error(w)) +
                          " because of the speed of the push, more than the " +
                          error_text(solver.accuracy) +
                          " asked for (solver.accuracy); a smaller one slows it");
}

/// The force touches the ultimate share of the peak, or falls slowly there.
void add_wide_fall(const FragilityInput& fragility, const PushedWall& w,
                   std::vector<std::string>& remarks)
{
    constexpr double kWide = 0.1; // of the ultimate displacement, a free choice
    if (!(ultimate_error(w.reading) > kWide)) return;
    const fragility::DropRange& range = w.reading.ultimate_range;
    remarks.push_back("the ultimate displacement may be anything between " +
                      fixed(1e3 * range.earliest.displacement, 2) + " and " +
                      (is_censored(range.latest) ? "more than " : "") +
                      fixed(1e3 * range.latest.displacement, 2) +
                      " mm, because the force stays so close to " +
                      percent_text(fragility.ultimate_share) +
                      " of the peak that the solver error decides where it is down to that; a "
                      "smaller solver.accuracy may narrow it");
}

/// The force of a body push means little without the weight that it is a share of.
void add_load_factor(const PushedWall& w, std::vector<std::string>& remarks)
{
    if (w.loads.pattern != dem::LoadPattern::body || !w.reading.peak) return;
    remarks.push_back("the peak force is " +
                      never_rounded_away(peak_force(w.reading) / w.result.weight, 3) +
                      " times the weight that is pushed (load factor); displacements are means "
                      "over the wall by weight");
}

/// Faces that rock have few contact points under pressure.
void add_few_points(const dem::SolverOptions& solver, const PushedWall& w,
                    std::vector<std::string>& remarks)
{
    const double error = points_error(w.result);
    if (error > solver.accuracy)
        remarks.push_back("the force may be wrong by " + error_text(error) +
                          " of the peak because of the few contact points on faces that rock, "
                          "which the solver error leaves out; write a larger "
                          "solver.contact_points");
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

/// Joints as stiff as stone yield before the first point of a side: its stiffness is then that
/// of the spacing of points.
void add_coarse_begin(const PushedWall& w, std::vector<std::string>& remarks)
{
    constexpr double kMost = 0.7; // of the peak, above the 60 % of the bilinear; a free choice
    const double peak = std::abs(peak_force(w.reading));
    if (!w.reading.stiffness || !(peak > 0.0)) return;
    bool right = false, left = false; // have a point
    for (std::size_t i = 0; i < w.force.size() && !(right && left); ++i) {
        const double u = w.displacement[i], share = std::abs(w.force[i]) / peak;
        if (u == 0.0 || std::exchange(u > 0.0 ? right : left, true) || !(share > kMost))
            continue;
        remarks.push_back("the force is at " + percent_text(share) +
                          " of the peak by the first point of the curve, at " +
                          never_rounded_away(1e3 * std::abs(u), 2) +
                          " mm: the wall is stiffer than the stiffness read, and yields "
                          "earlier; write a smaller output.record_every");
        return;
    }
}

/// A wall that is drawn, has openings, or is bonded by mortar, has no closed form here: its
/// loads alone.
HandChecks loads_alone(const dem::Elastic& stone, const dem::Beam& beam, const PushedWall& w,
                       const dem::Layout& layout)
{
    const dem::Weights weights = dem::weights_of(layout, stone, beam.material, w.loads.gravity);
    HandChecks h;
    h.vertical_load = weights.beam;
    h.wall_weight = weights.free; // the floor carries the rest
    if (beam.present) h.vertical_load += w.vertical_stress * layout.length * layout.thickness;
    return h;
}

/// Compares a peak with the limits of a wall that can turn.
/// @param slides whether anything in it can slide
void add_beyond_limits(const dem::Beam& beam, bool slides, double peak, HandChecks& h)
{
    const bool turns = beam.rotation == dem::BeamRotation::free;
    if (turns) add_beyond("rigid rocking", peak, *h.rocking_limit, h.remarks);
    if (h.sliding_limit) add_beyond("sliding", peak, *h.sliding_limit, h.remarks);
    if (turns) return;
    if (!slides) {
        h.remarks.emplace_back(
            "the beam does not turn and the toe is held: nothing can rock or slide, and only "
            "cracks and crushing limit the force");
        return;
    }
    h.remarks.emplace_back(
        "the beam does not turn: the rocking limit is that of a beam that turns; "
        "up to twice as much can be carried");
    add_beyond("rocking in double bending, twice that of a beam that turns", peak,
               2.0 * *h.rocking_limit, h.remarks);
}

HandChecks limits_of(const Masonry& masonry, const std::vector<RandomInput>& random,
                     const PushedWall& w)
{
    const Parameters& p = masonry.parameters;
    dem::Loads loads = w.loads;
    loads.vertical_stress = w.vertical_stress;
    const dem::RigidWall rigid =
        dem::rigid_wall(masonry.wall, masonry.beam, p.stone, loads,
                        {std::tan(p.joint.friction_angle), std::tan(p.base_friction_angle),
                         std::tan(p.beam_friction_angle)},
                        w.result.weight);
    HandChecks h;
    h.vertical_load = rigid.vertical_load;
    h.wall_weight = rigid.weight;
    h.rocking_limit = rigid.rocking_limit;
    const bool drawn = std::ranges::any_of(random, [](const RandomInput& r) {
        return r.key == "joint.friction_angle" || r.key == "base.friction_angle" ||
               r.key == "beam.friction_angle";
    });
    if (!drawn && std::isfinite(rigid.sliding_limit)) h.sliding_limit = rigid.sliding_limit;
    if (rigid.turning == 0)
        h.remarks.emplace_back(
            masonry.beam.present
                ? "a single course on a fixed base: no joint can open or slide below "
                  "the beam; only cracks and crushing can end the wall"
                : "a single course on a fixed base: nothing can move");
    if (rigid.turning > 0)
        add_beyond_limits(masonry.beam, std::isfinite(rigid.sliding_limit),
                          peak_force(w.reading), h);
    return h;
}

} // namespace

HandChecks hand_checks(const Study& study, const dem::Layout& layout, const PushedWall& w)
{
    const bool closed_form = layout.coursed && !layout.mortar && study.wall.openings.empty();
    HandChecks h = closed_form ? limits_of(study, study.random, w)
                               : loads_alone(study.parameters.stone, study.beam, w, layout);
    if (!dem::failed(w.result.outcome))
        h.toe_stress = dem::toe_stress(w.result.at_end, study.wall.base);
    add_load_factor(w, h.remarks);
    add(no_limit_remark(study.load, study.solver, study.fragility, w.reading), h.remarks);
    add(no_yield_remark(w.reading), h.remarks);
    add(other_way_remark(study.load, study.source, layout, w), h.remarks);
    const ReadingRules rules = reading_rules(study);
    if (w.piers.empty()) add(pier_remark(rules, study), h.remarks);
    for (std::string& remark : piers_remarks(rules, w)) add(std::move(remark), h.remarks);
    add_inaccurate(study.solver, w, h.remarks);
    add_wide_fall(study.fragility, w, h.remarks);
    add_few_points(study.solver, w, h.remarks);
    add_coarse_peak(w, h.remarks);
    add_coarse_begin(w, h.remarks);
    add_slid_off(study.solver, w, h.remarks);
    if (!layout.coursed) add_local_drag(study.solver, h.remarks);
    add_sliding_beam(study.beam, w, h.remarks);
    add_toe_stress(study.parameters, h, h.remarks);
    add_lost(w, h.remarks);
    add_unsettled(w, h.remarks);
    add_slow_start(w, h.remarks);
    return h;
}

} // namespace app
