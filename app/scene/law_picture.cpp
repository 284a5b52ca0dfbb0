#include "app/scene/law_picture.hpp"

#include "app/output/picture/chart_svg.hpp"
#include "app/output/picture/svg_elements.hpp"
#include "app/text/number_text.hpp"
#include "dem/solver/law_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace app {
namespace {

using dem::LawMove;
using dem::LawPoint;

constexpr double kWidth = 400.0, kHeight = 320.0, kHead = 30.0; // of one chart, of the title
constexpr int kSteps = 400;                                     // of one way
constexpr int kFine = 8000; // where the largest stress of a brittle law is looked for

using Path = std::function<std::vector<LawPoint>(std::span<const LawMove>)>;

/// One kind of contact: how it answers, and the range that shows its law.
struct DrawnLaw {
    std::string name;
    Path path = {};
    double kn = 0.0, ks = 0.0; ///< [Pa/m]
    double tension = 0.0;      ///< strength [Pa]; 0: none
    double opening = 0.0;      ///< at which no tension is left [m]
    double pressure = 0.0;     ///< largest that is drawn [Pa]
    double softening = 0.0;    ///< slip that breaks the bond, beyond the elastic one [m]
    std::vector<double> pressures = {}; ///< under which it slips [Pa]
};

/// So far in equal moves.
void go(std::vector<LawMove>& moves, double du_n, double du_s, int steps = kSteps)
{
    moves.insert(moves.end(), static_cast<std::size_t>(steps),
                 LawMove{du_n / steps, du_s / steps});
}

/// Moves that press the contact until it carries this pressure [Pa].
std::vector<LawMove> pressed(const DrawnLaw& law, double pressure)
{
    const double by = pressure / (law.kn * kSteps);
    constexpr int kLongest = 40 * kSteps; // a joint that closes is softer at first
    std::vector<LawMove> moves;
    go(moves, -by * kLongest, 0.0, kLongest);
    const std::vector<LawPoint> path = law.path(moves);
    const auto there = std::ranges::find_if(
        path, [&](const LawPoint& at) { return -at.sigma >= pressure * (1.0 - 1e-9); });
    moves.resize(pressure > 0.0 ? static_cast<std::size_t>(there - path.begin()) : 0);
    return moves;
}

/// Slip that shows what is left once the bond is gone [m].
double whole_slip(const DrawnLaw& law, double strength)
{
    return 1.6 * (strength / law.ks + law.softening);
}

/// Moves that slip at a stress.
std::vector<LawMove> slipped(const DrawnLaw& law, double sigma, double slip, int steps = kSteps)
{
    std::vector<LawMove> moves;
    if (sigma > 0.0)
        go(moves, sigma / law.kn, 0.0);
    else
        moves = pressed(law, -sigma);
    go(moves, 0.0, slip, steps);
    return moves;
}

double largest_shear(std::span<const LawPoint> path)
{
    double most = 0.0;
    for (const LawPoint& at : path) most = std::max(most, at.tau);
    return most;
}

/// More than the shear strength under a pressure [Pa].
double shear_bound(const DrawnLaw& law, double pressure)
{
    double slip = (law.tension + pressure) / law.ks;
    for (int doubled = 0; doubled < 12; ++doubled, slip *= 2.0) {
        const double most = largest_shear(law.path(slipped(law, -pressure, slip)));
        if (most < 0.99 * law.ks * slip) return most;
    }
    return law.ks * slip;
}

Chart small_chart(std::string title, std::string x, std::string y)
{
    Chart c;
    c.title = std::move(title);
    c.x_label = std::move(x);
    c.y_label = std::move(y);
    c.width = kWidth;
    c.height = kHeight;
    return c;
}

/// Points between neighbours on a straight line are left out.
Series line_of(std::span<const LawPoint> path, std::size_t from, double LawPoint::*x,
               double LawPoint::*y)
{
    Series s;
    for (std::size_t i = from; i < path.size(); ++i) {
        if (i > from && i + 1 < path.size()) {
            const double dx = path[i].*x - path[i - 1].*x, dy = path[i].*y - path[i - 1].*y;
            const double ex = path[i + 1].*x - path[i].*x, ey = path[i + 1].*y - path[i].*y;
            const bool onward = dx * ex + dy * ey > 0.0;
            if (onward &&
                std::abs(dx * ey - dy * ex) <= 1e-6 * (std::abs(dx * ey) + std::abs(dy * ex)))
                continue;
        }
        s.x.push_back(path[i].*x * 1e3);
        s.y.push_back(path[i].*y * 1e-6);
    }
    return s;
}

/// Opens half way, closes, opens to the end. A dry joint closes and opens again.
Chart normal_chart(const DrawnLaw& law)
{
    Chart c =
        small_chart(law.name + ", opened and closed", "opening [mm]", "normal stress [MPa]");
    std::vector<LawMove> moves;
    if (law.tension > 0.0) {
        const double elastic = law.tension / law.kn, end = std::max(elastic, law.opening);
        const double half = 0.5 * (elastic + end);
        go(moves, half, 0.0);
        go(moves, -half - elastic, 0.0);
        go(moves, elastic + 1.3 * end, 0.0);
    } else {
        moves = pressed(law, law.pressure);
        double closed = 0.0;
        for (const LawMove& m : moves) closed -= m.du_n;
        go(moves, 1.2 * closed, 0.0);
    }
    c.series.push_back(line_of(law.path(moves), 0, &LawPoint::u_n, &LawPoint::sigma));
    return c;
}

Chart slip_chart(const DrawnLaw& law)
{
    Chart c = small_chart(law.name + ", slipping", "slip [mm]", "shear stress [MPa]");
    const double most = shear_bound(law, law.pressures.back());
    for (const double p : law.pressures) {
        const std::vector<LawMove> moves = slipped(law, -p, whole_slip(law, most));
        const std::vector<LawPoint> path = law.path(moves);
        Series s = line_of(path, path.size() - kSteps - 1, &LawPoint::u_s, &LawPoint::tau);
        s.name = number(p * 1e-6, 3) + " MPa";
        c.series.push_back(std::move(s));
    }
    return c;
}

Chart strength_chart(const DrawnLaw& law)
{
    Chart c = small_chart(law.name + ", strength", "normal stress [MPa]", "shear stress [MPa]");
    Series before{.name = law.tension > 0.0 ? "intact" : ""};
    Series after{.name = "broken", .line = LineStyle::dashed};
    constexpr int kPoints = 40;
    const double slip = whole_slip(law, shear_bound(law, law.pressure));
    const auto add = [&](double sigma) {
        const std::vector<LawPoint> path = law.path(slipped(law, sigma, slip, kFine));
        // Pressed in steps, it carries a little more than asked for.
        const double at = sigma > 0.0 ? sigma : path[path.size() - kFine - 1].sigma;
        before.x.push_back(at * 1e-6);
        before.y.push_back(largest_shear(path) * 1e-6);
        after.x.push_back(std::min(0.0, at) * 1e-6);
        after.y.push_back(path.back().tau * 1e-6);
    };
    for (int i = 0; i <= kPoints; ++i) add(law.pressure * (i - kPoints) / kPoints);
    for (int i = 1; i <= kPoints && law.tension > 0.0; ++i)
        add(law.tension * (1.0 - 1e-9) * i / kPoints);
    c.series.push_back(std::move(before));
    if (law.tension > 0.0) c.series.push_back(std::move(after));
    return c;
}

/// One digit.
double rounded(double x)
{
    const double unit = std::pow(10.0, std::floor(std::log10(x)));
    return std::round(x / unit) * unit;
}

DrawnLaw law_of(const dem::CrackMaterial& crack, std::string name, const dem::CrackLaws& laws)
{
    DrawnLaw law{.name = std::move(name), .kn = crack.kn, .ks = crack.ks, .tension = crack.ft};
    law.path = [crack, laws](std::span<const LawMove> moves) {
        return dem::crack_path(crack, laws, moves);
    };
    law.opening = crack.ft > 0.0 ? 2.0 * crack.fracture_energy / crack.ft : 0.0;
    if (crack.cohesion > crack.cohesion_res)
        law.softening =
            2.0 * crack.shear_fracture_energy / (crack.cohesion - crack.cohesion_res);
    const double step = rounded(std::max({crack.cohesion, crack.ft, 1e3}) / 2.0);
    law.pressure = 4.0 * step;
    law.pressures = {0.0, step, 2.0 * step};
    return law;
}

DrawnLaw law_of(const dem::JointMaterial& joint, dem::Closure closure, double stress)
{
    constexpr double kLeast = 0.1e6; // [Pa], where no vertical stress is given
    DrawnLaw law{.name = "Dry joint", .kn = joint.kn, .ks = joint.ks};
    law.path = [joint, closure](std::span<const LawMove> moves) {
        return dem::joint_path(joint, closure, moves);
    };
    const double step = std::max(stress, kLeast);
    law.pressure = 4.0 * step;
    law.pressures = {0.5 * step, step, 2.0 * step};
    return law;
}

} // namespace

std::string law_picture(const Parameters& p, double course_height, StressLevel level,
                        const dem::Layout& layout, const dem::SolverOptions& solver)
{
    const dem::CrackLaws laws{layout.mixed_mode, solver.law, solver.unloading};
    const dem::JointMaterial joint = joint_material(p, course_height, level);
    std::vector<DrawnLaw> drawn;
    if (layout.n_cracks > 0)
        drawn.push_back(
            law_of(crack_material(p, course_height, level, dem::own_stiffness(layout, 0)),
                   "Crack in a unit", laws));
    drawn.push_back(layout.mortar ? law_of(bond_of(joint), "Joint with mortar", laws)
                                  : law_of(joint, layout.closure, level.stress));
    std::string body =
        svg_text({12.0, 20.0},
                 "Mean values under " + number(level.stress * 1e-6, 4) +
                     " MPa, each curve by moving one contact; opening and tension are positive",
                 "font-weight=\"bold\"");
    double y = kHead;
    for (const DrawnLaw& law : drawn) {
        double x = 0.0;
        for (const Chart& chart : {normal_chart(law), slip_chart(law), strength_chart(law)}) {
            const std::string at =
                svg_attribute("x", svg_number(x)) + svg_attribute("y", svg_number(y));
            body += "<svg " + at + line_chart(chart).substr(std::string_view("<svg ").size());
            x += kWidth;
        }
        y += kHeight;
    }
    return svg_page(3.0 * kWidth, y, "Laws of the contacts", body);
}

} // namespace app
