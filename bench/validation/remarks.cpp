#include "bench/validation/remarks.hpp"

#include "app/number_text.hpp"
#include "bench/validation/paper_tables.hpp"

#include <cmath>

namespace bench {
namespace {

constexpr double kWall = 4.51,
                 kBeam = 0.47; // weights with our densities, configs/paper.ini [kN]

/// Peak of a rigid wall that overturns about its toe, load line at 1.10 m [kN].
double rigid_limit(double vertical, double weight) { return (vertical + weight) * 0.5 / 1.10; }

std::string percent(double ratio) { return app::fixed(100.0 * (ratio - 1.0), 1) + " %"; }

std::string kilonewton(double force) { return app::fixed(force, 2) + " kN"; }

std::string share(std::size_t k, std::size_t n)
{
    return app::fixed(100.0 * static_cast<double>(k) / static_cast<double>(n), 0) + " %";
}

std::string lowest_stress(const LevelStatistics& s)
{
    const double paper = pooled_peak(kPaperLevels[0]), limit = rigid_limit(30.0, kWall + kBeam);
    return "**Force at 0.15 MPa, " + percent(s.peak_kN.mean / paper) +
           ".** Two causes. Weight: a rigid wall of " + kilonewton(kWall) +
           " under a beam of " + kilonewton(kBeam) + " and 30 kN overturns at " +
           kilonewton(limit) + "; the paper's mean, " + kilonewton(paper) +
           ", is above that, so its wall and beam must be heavier than ours by " +
           kilonewton(paper * 2.2 - 30.0 - kWall - kBeam) +
           " at least. It gives no densities; what they do is in section 5. Friction: " +
           share(s.slid_walls, s.walls) +
           " of our walls have too little of it to overturn, and slide along a course at less "
           "force; the mean of the others is " +
           kilonewton(s.unslid_kN.mean) + " (" + percent(s.unslid_kN.mean / paper) +
           "). The paper draws the same angles, yet a mean at the limit of overturning leaves "
           "no "
           "room for walls that slid; it does not say what held them.";
}

std::string displacements(const OurLevels& ours, const std::vector<Sample>& last)
{
    std::string first_text, last_text, paper_text;
    for (std::size_t l = 1; l < kPaperLevels.size(); ++l) {
        const char* const slash = l > 1 ? " / " : "";
        first_text += slash + app::fixed(ours.large[l].mixed.displacement_mm.mean, 1);
        last_text += slash + app::fixed(last[l].mean, 1);
        paper_text += slash + app::fixed(kPaperLevels[l].mixed->displacement_mm, 1);
    }
    return "**Displacement of mixed-mode walls.** Our curves are jerky, as the paper's are "
           "(\"several "
           "drops and rises, oscillating around 80%\"): which fall counts decides the mean. "
           "The "
           "first one gives " +
           first_text +
           " mm at 0.50 / 0.75 / 1.00 / 1.25 MPa, the last one, after which the force stays "
           "below or the run ends, " +
           last_text + " mm; the paper, which does not say which it took, has " + paper_text +
           " mm, between them and nearer to the first.";
}

std::string shares(const OurLevels& ours)
{
    const LevelStatistics& s = ours.large.back();
    return "**Shares of modes.** The paper tells modes apart by looking at each wall; ours are "
           "named by a "
           "rule ([model.md](model.md), section 5) with two thresholds, whose effect is in the "
           "last "
           "rows of section 5. At 1.25 MPa " +
           share(s.rocking_walls, s.walls) + " of our walls rock, " +
           share(kPaperLevels.back().rocking_walls, kPaperLevels.back().walls) +
           " of the paper's: 4 walls of 50, a difference that samples of that size show by "
           "chance.";
}

} // namespace

std::string remarks_on_tests()
{
    return "Both tests under 30 kN stay above the limit of a rigid wall that overturns: 21.5 "
           "and 22.7 kN "
           "against " +
           app::fixed(rigid_limit(30.0, kWall + kBeam), 1) +
           " kN. No model without tension in its joints can reach them; the paper's mean is 27 "
           "% "
           "below them too. SW.30.1 has a plateau of 15.8 to 17.1 kN from 3 to 8 mm before it "
           "climbs, and that is what the curves here follow. Repeated tests of one stress "
           "differ "
           "by up to 15 % in peak force.";
}

std::string remarks_on_differences(const OurLevels& ours, const std::vector<Sample>& last_falls)
{
    return lowest_stress(ours.large.front()) + "\n\n" + displacements(ours, last_falls) +
           "\n\n" + shares(ours);
}

} // namespace bench
