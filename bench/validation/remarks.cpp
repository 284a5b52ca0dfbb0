#include "bench/validation/remarks.hpp"

#include "app/text/number_text.hpp"
#include "bench/validation/paper_tables.hpp"

#include <cmath>

namespace bench {
namespace {

/// Peak of a rigid wall under 30 kN that turns about the toe of its fixed first course [kN].
double rigid_limit(const app::Study& s)
{
    const double above = (s.wall.courses - 1) * s.wall.course_height;
    const double weight =
        s.load.gravity * s.wall.length * s.wall.thickness *
        (s.parameters.stone.density * above + s.beam.material.density * s.beam.height);
    const double arm = s.load.height - s.wall.course_height;
    return (30.0 + 1e-3 * weight) * 0.5 * s.wall.length / arm;
}

std::string percent(double ratio) { return app::fixed(100.0 * (ratio - 1.0), 1) + " %"; }

std::string kilonewton(double force) { return app::fixed(force, 2) + " kN"; }

std::string share(std::size_t k, std::size_t n)
{
    return app::fixed(100.0 * static_cast<double>(k) / static_cast<double>(n), 0) + " %";
}

/// "+4.2 %": peak of all walls under the lowest stress with a choice changed.
std::string change(const Remarkable& r, const std::vector<LevelStatistics>& changed)
{
    const double ratio = changed.front().peak_kN.mean / r.ours.same_size.front().peak_kN.mean;
    return (ratio > 1.0 ? "+" : "") + percent(ratio);
}

std::string lowest_stress(const Remarkable& r)
{
    const LevelStatistics& s = r.ours.large.front();
    const double paper = pooled_peak(kPaperLevels[0]), limit = r.rigid_limit.peak_kN.mean;
    return "**Force at 0.15 MPa, " + percent(s.peak_kN.mean / paper) + ".** " +
           share(s.slid_walls, s.walls) +
           " of our walls have too little friction to overturn: they slide along a course as a "
           "whole, at less force. The mean of the others is " +
           kilonewton(s.unslid_kN.mean) + ", " + percent(s.unslid_kN.mean / paper) +
           ". The paper draws the same angles and counts all 50 walls as rocking. Weight "
           "matters most under this stress, and the paper gives none. Here the beam weighs 1.5 "
           "kN, wall and beam 6.0 kN. Before a first comparison the beam weighed 0.5 kN (a bar "
           "of concrete), which gives " +
           change(r, r.light_beam) +
           " ([model.md](model.md), section 6, gives the reason for the change). A load 50 mm "
           "lower gives " +
           change(r, r.low_load) +
           ". Mesh, damping and speed of the push move the mean by less than 1 % unless the "
           "push is far too fast (section 5). Rigid blocks on joints 30 times as stiff carry " +
           kilonewton(limit) + ", " + percent(limit / paper) + ", the sliding walls included.";
}

/// "15.1 / 16.8", levels from the second on.
template <class Value> std::string of_levels(Value value)
{
    std::string text;
    for (std::size_t l = 1; l < kPaperLevels.size(); ++l)
        text += (l > 1 ? " / " : "") + app::fixed(value(l), 1);
    return text;
}

/// The same of the number of the paper's walls of mixed mode and the level.
template <class Cell> std::string of_mixed(Cell cell)
{
    std::string text;
    for (std::size_t l = 1; l < kPaperLevels.size(); ++l)
        text +=
            (l > 1 ? " / " : "") +
            cell(static_cast<double>(kPaperLevels[l].walls - kPaperLevels[l].rocking_walls), l);
    return text;
}

std::string displacements(const Remarkable& r)
{
    const auto displacement = [](const std::vector<LevelStatistics>& levels) {
        return [&](std::size_t l) { return levels[l].mixed.displacement_mm.mean; };
    };
    return "**Displacement of mixed-mode walls**, at 0.50 / 0.75 / 1.00 / 1.25 MPa " +
           of_levels(displacement(r.ours.large)) + " mm against the paper's " +
           of_levels([](std::size_t l) { return kPaperLevels[l].mixed->displacement_mm; }) +
           " mm. The paper's values are means of " +
           of_mixed([](double n, std::size_t) { return app::fixed(n, 0); }) +
           " walls; with our COV they are uncertain by " +
           of_mixed([&](double n, std::size_t l) {
               return app::fixed(1.96 * r.ours.large[l].mixed.displacement_mm.cov() *
                                     kPaperLevels[l].mixed->displacement_mm / std::sqrt(n),
                                 1);
           }) +
           " mm (95 %). Damping changes these displacements. These walls have the damping of "
           "the paper, local, 0.8 (Eq. 1). For the first 50 walls a factor of 0.5 / 0.8 / 0.95 "
           "gives " +
           of_levels(displacement(r.weak_damping)) + ", " +
           of_levels(displacement(r.ours.same_size)) + " and " +
           of_levels(displacement(r.strong_damping)) +
           " mm; combined damping, the default of the program, gives " +
           of_levels(displacement(r.combined_damping)) +
           " mm. Most of the difference is drag on moving blocks, which combined damping does "
           "not have: [model.md](model.md), section 4. The reading matters too: the curves are "
           "jerky, like the paper's (\"several drops and rises, oscillating around 80%\"). The "
           "last fall, after which the force stays below 80 %, or the end of the run, would "
           "give " +
           of_levels([&](std::size_t l) { return r.last_falls[l].mean; }) + " mm.";
}

std::string shares(const OurLevels& ours)
{
    const LevelStatistics& s = ours.large.back();
    return "**Shares of modes.** The paper tells modes apart by looking at each wall; the "
           "program uses a rule of two thresholds ([model.md](model.md), section 5; the last "
           "rows of section 5 here show their effect). The rule was changed once after a first "
           "comparison. Before, one cracked unit alone, or slip of a quarter of the "
           "displacement, made a wall mixed. This left 78 / 12 / 4 / 2 / 0 % of rocking walls "
           "(50 under each stress) and called walls mixed that kept their load and overturned, "
           "or slid as a whole. At 1.25 MPa " +
           share(s.rocking_walls, s.walls) + " of our walls rock; in the paper " +
           share(static_cast<std::size_t>(kPaperLevels.back().rocking_walls),
                 static_cast<std::size_t>(kPaperLevels.back().walls)) +
           ", 4 walls of 50.";
}

std::string joint_inputs_in_words(const LevelStatistics& wall, const JointInputs& inputs)
{
    const auto force = [](double kN) { return app::fixed(kN, 1) + " kN"; };
    return "A wall of mean values carries " + force(inputs.none.peak_kN.mean) +
           ". With friction alone per joint the mean is " +
           force(inputs.joint_friction.peak_kN.mean) + ", with all five inputs " +
           force(inputs.all.peak_kN.mean) + "; in the paper it is " +
           force(pooled_peak(kPaperSpatial)) +
           ". Friction that scatters half as much again would give " +
           force(inputs.more_scatter.peak_kN.mean) + ", but with " +
           share(inputs.more_scatter.rocking_walls, inputs.more_scatter.walls) +
           " of rocking walls instead of " + share(inputs.all.rocking_walls, inputs.all.walls) +
           " (paper: " +
           share(static_cast<std::size_t>(kPaperSpatial.rocking_walls),
                 static_cast<std::size_t>(kPaperSpatial.walls)) +
           "). Values that are the same along a course would give " +
           force(inputs.by_course.peak_kN.mean) + ", with " +
           share(inputs.by_course.rocking_walls, inputs.by_course.walls) +
           " of rocking walls and a COV of " + app::fixed(inputs.by_course.peak_kN.cov(), 3) +
           " (per wall " + share(wall.rocking_walls, wall.walls) + " and " +
           app::fixed(wall.peak_kN.cov(), 3) + "). ";
}

std::string per_joint(const LevelStatistics& wall, const LevelStatistics& joint,
                      const JointInputs& inputs)
{
    const double paper = pooled_peak(kPaperSpatial) / pooled_peak(kPaperLevels[2]);
    return "**Values per joint.** As in the paper there are fewer rocking walls, lower forces "
           "and less scatter: the COV of the peak falls from " +
           app::fixed(wall.peak_kN.cov(), 3) + " to " + app::fixed(joint.peak_kN.cov(), 3) +
           ". The mean peak changes by " + percent(joint.peak_kN.mean / wall.peak_kN.mean) +
           ", in the paper by " + percent(paper) + ". " + joint_inputs_in_words(wall, inputs) +
           "The paper's text does not explain why its fall is larger. The force of the "
           "equal-energy bilinear of our spatial walls is " +
           app::fixed(joint.mixed.plateau_kN.mean, 1) + " kN (mixed) and " +
           app::fixed(joint.plateau_kN.mean, 1) + " kN (all); the paper's Table 8 has " +
           app::fixed(kPaperSpatial.mixed->peak_kN, 1) + " and " +
           app::fixed(pooled_peak(kPaperSpatial), 1) +
           " kN. "
           "More walls of mixed mode "
           "keep 80 "
           "% of their peak to the end of the run, which raises their mean displacement; for "
           "walls that fell it is " +
           app::fixed(wall.mixed.dropped_mm.mean, 1) + " mm per wall and " +
           app::fixed(joint.mixed.dropped_mm.mean, 1) + " mm per joint.";
}

} // namespace

std::string remarks_on_tests(const app::Study& study)
{
    return "Both tests under 30 kN, 21.5 and 22.7 kN, stay above " +
           app::fixed(rigid_limit(study), 1) +
           " kN, the force at which a rigid wall turns about the toe of a first course that is "
           "fixed. This model cannot reach the two tests; the paper's mean is also 27 % below "
           "them. SW.30.1 has a plateau of 15.8 to 17.1 kN from 3 to 8 mm before it climbs; "
           "the curves here follow this plateau. Repeated tests under one stress differ by up "
           "to 15 % in peak force.";
}

std::string remarks_on_differences(const Remarkable& r)
{
    return lowest_stress(r) + "\n\n" + displacements(r) + "\n\n" + shares(r.ours) + "\n\n" +
           per_joint(r.ours.large[2], r.per_joint, r.joint_inputs);
}

} // namespace bench
