#include "app/input/study_checks.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/input/study/study.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/input/wall/slivers.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/bond.hpp"
#include "dem/scene/layout.hpp"
#include "dem/solver/state/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace app {
namespace {

[[noreturn]] void refuse(const StudyFile& source, std::string_view key, const std::string& why)
{
    throw error_at(source, key, why);
}

constexpr double kMostPoints = 1e6; // of a curve

void check_residuals(const dem::CrackParameters& u, const StudyFile& source)
{
    if (u.residual_cohesion > u.cohesion) {
        refuse(source, "unit.residual_cohesion",
               "must be at most unit.cohesion, " + quantity_text(u.cohesion, "MPa"));
    }
    if (u.residual_friction_angle > u.friction_angle) {
        refuse(source, "unit.residual_friction_angle",
               "must be at most unit.friction_angle, " +
                   quantity_text(u.friction_angle, "deg"));
    }
}

void check_bond(const Masonry& masonry, const StudyFile& source)
{
    if (!in_courses(masonry.geometry)) return;
    if (masonry.wall.bond != dem::Bond::shifted &&
        masonry.wall.header_length > masonry.wall.unit_length)
        refuse(source, "wall.header_length",
               "must be at most wall.unit_length, " +
                   quantity_text(masonry.wall.unit_length, "m"));
    if (masonry.wall.bond != dem::Bond::shifted || masonry.wall.length_cov == 0.0) return;
    const double most = dem::most_length_cov(masonry.wall);
    if (masonry.wall.length_cov > most)
        refuse(source, "wall.unit_length_cov",
               "head joints would pass those of the next course; write at most " +
                   number(std::floor(most * 1e3) / 1e3, 3));
}

void check_length(const Masonry& masonry, const StudyFile& source)
{
    if (!is_drawn(masonry.geometry) && masonry.wall.length < masonry.wall.unit_length) {
        refuse(source, "wall.length",
               "must be at least one wall.unit_length, " +
                   quantity_text(masonry.wall.unit_length, "m"));
    }
}

/// Pieces that share the stiffness of their unit with cracks take a larger Poisson's ratio than
/// it has.
void check_poisson(const Masonry& masonry, const StudyFile& source)
{
    if (!any_pattern(masonry, source, dem::shares_stiffness)) return;
    const auto refuse_ratio = [&](std::string_view key, const dem::Elastic& stone,
                                  const std::string& whose) {
        const double rigidity = masonry.wall.cracks.rigidity;
        if (dem::between_cracks(stone, rigidity).poisson_ratio < 0.5) return;
        refuse(source, key,
               whose + number(stone.poisson_ratio, 6) + " must be below " +
                   number(0.5 * (1.0 - 1.0 / rigidity), 4) +
                   ", 0.5 (1 - 1 / unit.crack_rigidity), where unit.cracks divides units into "
                   "pieces with cracks on all sides");
    };
    refuse_ratio("stone.poisson_ratio", masonry.parameters.stone, "");
    for (std::size_t k = 0; k < masonry.geometry.stones.size(); ++k)
        if (masonry.geometry.layers[k] != "lintel")
            refuse_ratio("wall.layer_stones", masonry.geometry.stones[k],
                         "Poisson's ratio of " + masonry.geometry.layers[k] + ", ");
}

/// Beyond this a block takes minutes and gigabytes to condense.
void check_zones(const dem::Discretisation& d, const StudyFile& source)
{
    constexpr int kMostZones = 100; // along a face of half a unit
    const int zones = (d.contact_points - 1) * d.zones_per_interval;
    if (zones > kMostZones)
        refuse(source,
               find_entry(source, "solver.zones_per_interval") ? "solver.zones_per_interval"
                                                               : "solver.contact_points",
               "makes " + std::to_string(zones) +
                   " zones along a face; (contact_points - 1) x zones_per_interval must be at "
                   "most " +
                   std::to_string(kMostZones));
}

void check_load(const Masonry& masonry, const LoadInput& load, const StudyFile& source)
{
    const std::string unfit = unfit_height(load, masonry.beam, wall_height(masonry));
    if (!unfit.empty()) refuse(source, "load.height", unfit);
    double previous = 0.0;
    for (const double target : load.targets) {
        if (target == previous) {
            refuse(source, "load.targets",
                   quantity_text(target, "mm") + " follows " + quantity_text(previous, "mm") +
                       "; each target must differ from the one before, the first from 0 mm");
        }
        previous = target;
    }
    if (!load.targets.empty() && !load.amplitudes.empty())
        refuse(source, "load.amplitudes",
               "load.targets gives the displacements already; remove one of the two keys");
}

/// Checks what pushes, and what there is to push.
void check_pattern(const Masonry& masonry, const LoadInput& load, const Parameters& parameters,
                   const StudyFile& source)
{
    const bool body = load.pattern == dem::LoadPattern::body;
    if (body && find_entry(source, "load.height"))
        refuse(source, "load.height",
               "body forces act on every block; remove it, or write load.pattern = beam");
    if (body && masonry.beam.rotation == dem::BeamRotation::fixed)
        refuse(source, "beam.rotation",
               "body forces move the beam with the wall; write free, or load.pattern = beam");
    if (body && load.gravity == 0.0)
        refuse(source, "load.gravity",
               "body forces are in proportion to weight; write 9.81 m/s2");
    const bool heavy_beam = masonry.beam.present && masonry.beam.material.density > 0.0;
    if (body && parameters.stone.density == 0.0 && !heavy_beam)
        refuse(source, "stone.density",
               "body forces are in proportion to weight; write for example 2300 kg/m3");
    if (masonry.beam.present) return;
    if (!body)
        refuse(source, "beam.present",
               "without a beam nothing pushes the wall; write load.pattern = body");
    for (const double stress : load.vertical_stress)
        if (stress > 0.0)
            refuse(source, "load.vertical_stress",
                   quantity_text(stress, "MPa") +
                       " has no beam to act on; write 0 MPa, or beam.present = yes");
}

/// Dry joints carry nothing that does not press on them.
void check_pressed(const JointInput& joint, const LoadInput& load, const StudyFile& source)
{
    const auto& levels = load.vertical_stress;
    if (load.gravity > 0.0 || has_mortar(joint) || *std::ranges::min_element(levels) > 0.0)
        return;
    refuse(source, find_entry(source, "load.gravity") ? "load.gravity" : "load.vertical_stress",
           "without weight and under 0 MPa nothing presses on dry joints, and the wall carries "
           "nothing; write 9.81 m/s2, or a load.vertical_stress above 0 MPa");
}

/// How the vertical load follows matters to a wall that moves.
void check_top_load(const LoadInput& load, const dem::SolverOptions& solver,
                    const StudyFile& source)
{
    const bool link = load.top == dem::TopLoad::link;
    if (load.top != dem::TopLoad::dead && solver.kinematics == dem::Kinematics::small) {
        refuse(source, "load.top",
               "makes no difference to small displacements; set solver.kinematics = finite");
    }
    if (link && load.link_length == 0.0)
        refuse(source, "load.link_length",
               "is needed by load.top = link: for example 2 m, or -2 m for a tendon below");
    if (!link && load.link_length != 0.0)
        refuse(source, "load.link_length", "has no effect without load.top = link; remove it");
}

/// A protocol that no wall can finish.
void check_steps(const LoadInput& load, const dem::SolverOptions& solver,
                 const StudyFile& source)
{
    const PushWay way = push_way(load);
    const double least = 1e3 * way.length * solver.steps_per_mm;
    if (way.turns == 0 || load.stop_below > 0.0 ||
        least <= static_cast<double>(solver.most_steps))
        return;
    refuse(source, "solver.most_steps",
           "is less than the " + number(least, 3) + " steps that a path of " +
               quantity_text(way.length, "m") +
               " needs at least; ask for fewer cycles, or allow more steps");
}

/// The output that is kept must be more than nothing and fit into memory.
void check_output(const LoadInput& load, const OutputInput& out, const StudyFile& source)
{
    const PushWay way = push_way(load);
    const double path = way.length;
    if (out.record_every > path) {
        refuse(source, "output.record_every",
               "must be at most the path of the push, " + quantity_text(path, "mm"));
    }
    if (path / out.record_every + way.turns * dem::Recorder::kAfterTurn > kMostPoints) {
        refuse(source, "output.record_every", "makes more than 1000000 points; record fewer");
    }
}

} // namespace

std::string unfit_height(const LoadInput& load, const dem::Beam& beam, double top)
{
    constexpr double kRounding = 1e-9; // [m]
    if (load.pattern == dem::LoadPattern::body || !beam.present) return "";
    if (load.height >= top - kRounding && load.height <= top + beam.height + kRounding)
        return "";
    return "must lie within the loading beam, from " + quantity_text(top, "m") + " to " +
           quantity_text(top + beam.height, "m") +
           "; without this key it is the top of the beam";
}

void check_cycles(const LoadInput& load, const StudyFile& source)
{
    constexpr double kMostTurns = kMostPoints / dem::Recorder::kAfterTurn;
    const double turns = 2.0 * load.repeats * static_cast<double>(load.amplitudes.size());
    if (turns > kMostTurns)
        refuse(source, find_entry(source, "load.repeats") ? "load.repeats" : "load.amplitudes",
               "makes a path with " + fixed(turns, 0) +
                   " turns; ask for fewer cycles, so that there are at most " +
                   fixed(kMostTurns, 0));
}

/// No block and no piece of joint may be a sliver: its stiffness would be an accident of the
/// sizes.
void check_blocks(const Masonry& masonry, const StudyFile& source, const dem::Layout& layout)
{
    constexpr double kSmallest = dem::kShortestUnit;
    const dem::WallGeometry& wall = masonry.wall;
    const std::string_view culprit =
        find_entry(source, "wall.bond") ? "wall.bond" : "wall.unit_length";
    const auto refuse_piece = [&](const std::string& what, double length) {
        if (openings_make_slivers(masonry, source, kSmallest))
            refuse(source, "wall.openings",
                   what + " beside an opening or its lintel would be " +
                       number(std::round(length * 1e6) / 1e3, 17) +
                       " mm long; move or widen the opening, or change lintel.bearing, so that "
                       "none "
                       "is below 1 mm");
        refuse(source, culprit,
               what + " would be " + number(std::round(length * 1e6) / 1e3, 17) +
                   " mm long; choose wall.length, unit_length and bond so that none is below 1 "
                   "mm");
    };
    if (!in_courses(masonry.geometry)) return; // as drawn
    for (const dem::Block& b : layout.blocks) {
        const double extent = std::min(b.x1 - b.x0, b.z1 - b.z0);
        if (layout.divided && extent < kSmallest &&
            cracks_make_slivers(masonry, source, kSmallest))
            refuse(source, find_entry(source, "unit.cracks") ? "unit.cracks" : culprit,
                   "makes pieces below 1 mm; write fewer pieces, or larger cells");
        if (b.x1 - b.x0 < kSmallest) refuse_piece("a unit", b.x1 - b.x0);
    }
    if (layout.divided || wall.length_cov > 0.0) return; // joints may come close to cracks
    for (const dem::Face& f : layout.faces) {
        const double length = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
        if (length < kSmallest) refuse_piece("a piece of joint", length);
    }
}

void check_relations(const Study& study)
{
    check_residuals(study.parameters.unit, study.source);
    check_closed_stiffness(study.parameters.joint, study.load, study.source);
    check_mixed_modes(study, study.solver, study.source);
    check_bond(study, study.source);
    check_length(study, study.source);
    check_zones(study.discretisation, study.source);
    check_poisson(study, study.source);
    check_pattern(study, study.load, study.parameters, study.source);
    check_load(study, study.load, study.source);
    check_pressed(study.parameters.joint, study.load, study.source);
    check_top_load(study.load, study.solver, study.source);
    check_output(study.load, study.output, study.source);
    check_layouts(study, study.uq, study.source);
    check_steps(study.load, study.solver, study.source);
    check_bootstrap(study.fragility, study.source);
    check_model_factors(study.fragility, study.source);
}

void check_bootstrap(const FragilityInput& fragility, const StudyFile& source)
{
    constexpr int kFewest = 100; // the smallest p-value is 1 / (samples + 1), and 0.01 rejects
    const int samples = fragility.bootstrap;
    if (samples > 0 && samples < kFewest)
        refuse(source, "fragility.bootstrap",
               std::to_string(samples) + " samples cannot reject a law at p < 0.01; write " +
                   std::to_string(kFewest) + " or more, or 0 for no tests");
}

} // namespace app
