#include "bench/accuracy/accuracy_scene.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/sampling/wall_draw.hpp"
#include "app/text/number_text.hpp"
#include "bench/accuracy/accuracy_walls.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

std::string value(double x) { return app::number(x, 4); }

/// Data that the sections of a study share.
struct SceneDraw {
    WallForm form;
    DrawnWall wall;
    bool finite = false;
    bool to_fall = false; ///< far enough for the fall to 80 % of a block that turns over
    bool body = false;    ///< body forces push
    bool beam = true;
    double stress = 0.0;          ///< vertical [Pa]
    double young = 0.0, kn = 0.0; ///< [Pa] [Pa/m]
    std::string fidelity, load, extras;

    void add_extra(const char* what)
    {
        extras += (extras.empty() ? "" : ", ") + std::string(what);
    }
};

/// Draws the part that stays while a scene is drawn again, so that refused draws shift none of
/// it.
SceneDraw draw_frame(Draw& d)
{
    SceneDraw s;
    s.form = draw_form(d);
    const bool arch = s.form.kind == "arch";
    s.finite = d.chance(0.55);
    s.body = arch || d.chance(0.35);
    s.beam = !arch && (!s.body || d.chance(0.4));
    if (s.beam && !d.chance(0.12)) s.stress = d.log_uniform(0.02e6, 5e6);
    s.fidelity = d.one_of({"rigid", "simple", "simple", "standard"});
    s.young = d.log_uniform(5e9, 40e9);
    s.kn = d.log_uniform(1e9, 1e15);
    s.to_fall = s.finite && s.kn < 1e12 && d.chance(0.8);
    return s;
}

std::string stone_keys(const SceneDraw& s, Draw& d)
{
    const double nu = d.uniform(0.1, 0.3);
    const double density = d.uniform(1800.0, 2700.0);
    return "[stone]\nyoung_modulus = " + value(s.young * 1e-9) +
           " GPa\npoisson_ratio = " + value(nu) + "\ndensity = " + value(density) + " kg/m3\n";
}

std::string mortar_keys(Draw& d)
{
    const double strength = d.log_uniform(0.02, 0.5), cohesion = strength * d.uniform(1.0, 2.0);
    return "tensile_strength = " + value(strength) + " MPa\ncohesion = " + value(cohesion) +
           " MPa\nfracture_energy = " + value(d.log_uniform(2.0, 50.0)) + " N/m\n";
}

std::string crushing_keys(const SceneDraw& s, Draw& d)
{
    const double weakest = std::clamp(1.5e-6 * s.stress, 0.3, 10.0); // [MPa]
    std::string keys =
        "compressive_strength = " + value(weakest * d.log_uniform(1.0, 20.0)) + " MPa\n";
    if (d.chance(0.6))
        keys += "crushing_energy = " + value(d.log_uniform(100.0, 3e4)) + " N/m\n";
    return keys;
}

std::string joint_keys(SceneDraw& s, Draw& d)
{
    std::string keys = "[joint]\nnormal_stiffness = " + value(s.kn * 1e-9) + " GPa/m\n";
    const double angle = d.uniform(20.0, 60.0);
    keys += "friction_angle = " + value(angle) + " deg\n";
    if (d.chance(0.3)) {
        s.add_extra("mortar");
        keys += mortar_keys(d);
    }
    if (d.chance(0.28)) {
        s.add_extra("crushing");
        keys += crushing_keys(s, d);
    }
    if (d.chance(0.06)) {
        s.add_extra("wear");
        keys += "wear_length = " + value(d.log_uniform(1.0, 100.0)) + " mm\n";
        keys += "residual_friction_angle = " + value(angle * d.uniform(0.5, 1.0)) + " deg\n";
    }
    return keys;
}

/// Cracks of small walls in courses: one at mid-length, or patterns.
std::string crack_keys(SceneDraw& s, Draw& d)
{
    DrawnWall& w = s.wall;
    if (w.unit == 0.0) return {};
    if (w.stones > 14 || !d.chance(0.5)) {
        const bool mid = d.chance(0.5);
        if (mid) s.add_extra("cracks at mid");
        return mid ? "cracks = mid\n" : "cracks = none\n";
    }
    s.add_extra("cracks in patterns");
    const int pattern = d.integer(0, 3);
    w.stones *= pattern == 0 ? 3 : 4;
    if (pattern == 0) return "cracks = thirds\n";
    if (pattern == 1) return "cracks = grid(2, 2)\n";
    if (pattern == 2) return "cracks = diagonals\n";
    return "cracks = voronoi(" + value(1e3 * w.unit * d.uniform(0.4, 0.7)) + " mm)\n";
}

std::string unit_keys(SceneDraw& s, Draw& d)
{
    const double strength = d.log_uniform(0.3, 6.0), energy = d.log_uniform(5.0, 150.0);
    const double angle = d.uniform(25.0, 45.0);
    return "[unit]\n" + crack_keys(s, d) + "tensile_strength = " + value(strength) +
           " MPa\nfracture_energy = " + value(energy) +
           " N/m\nfriction_angle = " + value(angle) + " deg\n";
}

std::string beam_keys(const SceneDraw& s, Draw& d, bool level)
{
    if (!s.beam) return "[beam]\npresent = no\n";
    const double height = d.uniform(0.08, 0.2), young = d.log_uniform(5.0, 200.0),
                 density = d.uniform(500.0, 7500.0);
    return "[beam]\nheight = " + metres(height) + " m\nyoung_modulus = " + value(young) +
           " GPa\ndensity = " + value(density) +
           " kg/m3\ninterface = " + d.one_of({"tied", "joint"}) + "\n" +
           (level ? "rotation = fixed\n" : "");
}

std::string load_keys(SceneDraw& s, Draw& d, bool level)
{
    std::string keys = "[load]\nvertical_stress = " + value(s.stress * 1e-6) + " MPa\n";
    s.load = s.body            ? (s.beam ? "body, beam" : "body")
             : level           ? "level beam"
             : s.stress == 0.0 ? "own weight"
                               : "stress";
    if (s.body) keys += "pattern = body\n";
    if (!s.beam || !s.finite || s.stress == 0.0 || !d.chance(0.5)) return keys;
    const std::string top = d.one_of({"fixed_line", "follower", "link"});
    keys += "top = " + top + "\n";
    if (top == "link") {
        const double length = s.wall.height * d.uniform(1.0, 3.0);
        keys += "link_length = " + metres(d.chance(0.5) ? length : -length) + " m\n";
    }
    if (!s.body && !level) s.load = top;
    return keys;
}

/// Displacement of the wall as an elastic block under the force that turns it over [m];
/// roughly.
double elastic_way(const SceneDraw& s)
{
    const DrawnWall& w = s.wall;
    const double h = w.height, l = w.length;
    const double e = 1.0 / (1.0 / (s.kn * w.course_height) + 1.0 / s.young);
    const double force = (s.stress + 2e4 * h) * l * l / (2.0 * h); // [N/m]
    return force / (e * l) * (4.0 * std::pow(h / l, 2.0) * h + 3.0 * h);
}

constexpr double kSecondsPerStoneStep = 5e-7; // of small walls on one core, measured

/// A push of one metre costs so much, 20 times slower than with the drive for which the scenes
/// were drawn first [s]. Another estimate would draw other scenes.
double cost_per_metre(const SceneDraw& s)
{
    const DrawnWall& w = s.wall;
    const double courses = std::max(1.0, w.height / w.course_height);
    const double slowing = std::clamp(60.0 * courses / (1e6 * elastic_way(s)), 1.0, 20.0);
    const double pauses = s.finite && slowing < 1.5 ? 2.0 : 6.0;
    const double element = s.fidelity == "standard" ? 2.5 : s.fidelity == "simple" ? 1.3 : 1.0;
    return 20e6 * slowing * pauses * (w.stones + 3.0) * element * (s.finite ? 1.5 : 1.0) *
           kSecondsPerStoneStep;
}

/// How far: a share of the height, or to where a block as large as the wall has lost a fifth of
/// its force. Nothing where that costs a reference more than `seconds` of one core, unless less
/// of it shows what a stiff wall does.
std::optional<double> draw_way(const SceneDraw& s, Draw& d, double seconds)
{
    const DrawnWall& w = s.wall;
    double way = w.height * (s.finite ? d.log_uniform(0.02, 0.08) : d.log_uniform(0.005, 0.03));
    if (s.body) way *= 0.5; // of the middle
    if (s.to_fall)
        way = std::min(w.length * d.uniform(0.12, 0.2) * (s.stress > 0.0 || s.body ? 1.0 : 1.8),
                       0.15 * w.height);
    const double affordable = seconds / cost_per_metre(s), elastic = elastic_way(s);
    if (s.to_fall ? affordable < way : affordable < 0.4 * way && affordable < 60.0 * elastic)
        return {};
    way = std::min(way, affordable);
    if (way < 8.0 * elastic && seconds < 50.0) return {}; // very soft walls go no farther
    return way;
}

std::string solver_keys(const SceneDraw& s)
{
    return std::string("[solver]\nkinematics = ") + (s.finite ? "finite" : "small") +
           "\nfidelity = " + s.fidelity + "\n";
}

/// Nothing where it would cost too much.
std::optional<AccuracyScene> draw_scene(SceneDraw s, Draw& d, double seconds)
{
    s.wall = draw_wall(s.form, d);
    AccuracyScene scene;
    scene.text = "[wall]\n" + s.wall.keys;
    scene.text += stone_keys(s, d);
    scene.text += joint_keys(s, d);
    scene.text += unit_keys(s, d);
    const bool level = s.beam && !s.body && d.chance(0.12);
    scene.text += beam_keys(s, d, level);
    scene.text += load_keys(s, d, level);
    const std::optional<double> way = draw_way(s, d, seconds);
    if (!way) return {};
    const double max_mm = app::rounded(1e3 * *way, 3);
    scene.text += "max_displacement = " + value(max_mm) + " mm\n";
    if (d.chance(0.8)) scene.text += "stop_below = 0.7\n"; // the drop to 80 % is known by then
    scene.text += solver_keys(s);
    scene.text += "[output]\nparaview = no\nrecord_every = " + value(max_mm / 300.0) + " mm\n";
    scene.kind = s.wall.kind;
    scene.load = s.load;
    scene.extras = s.extras;
    scene.stones = s.wall.stones;
    return scene;
}

/// Whether it makes a wall that can be pushed.
bool is_accepted(const AccuracyScene& scene)
{
    try {
        const app::Study study = study_of(scene);
        const dem::Model model = app::model_of(app::prepare(study));
        dem::check(model,
                   app::wall_materials(study, study.random, app::stress_level(study.load, 0),
                                       model.layout, {}));
        return true;
    } catch (const std::runtime_error&) { // app::ConfigError
        return false;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

} // namespace

AccuracyScene accuracy_scene(std::uint64_t seed, std::uint64_t number)
{
    constexpr std::uint64_t kMostDraws = 2000, kDearer = 100;
    double seconds = 8.0; // of a reference; more where no wall is that cheap
    Draw of_frame(seed, number);
    const SceneDraw frame = draw_frame(of_frame);
    for (std::uint64_t again = 1; again <= kMostDraws; ++again) {
        if (again % kDearer == 0) seconds *= 1.5;
        Draw d(seed + (again << 32), number);
        std::optional<AccuracyScene> scene = draw_scene(frame, d, seconds);
        if (!scene) continue;
        scene->number = number;
        if (is_accepted(*scene)) return std::move(*scene);
    }
    throw std::logic_error("no draw of scene " + std::to_string(number) + " makes a wall");
}

app::Study study_of(const AccuracyScene& scene, std::span<const std::string> overrides)
{
    return app::read_study(app::with_overrides(
        app::parse_study_text("scene " + std::to_string(scene.number), scene.text), overrides));
}

} // namespace bench
