#include "bench/accuracy/accuracy_walls.hpp"

#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bench {

std::string metres(double x) { return app::fixed(x, 6); }

DrawnWall drawn_wall_of(std::string_view kind, std::vector<std::vector<Corner>> stones,
                        double thickness, int decimals)
{
    double left = 0.0, right = 0.0, top = 0.0;
    for (const auto& stone : stones)
        for (const Corner& c : stone) {
            left = std::min(left, c.x);
            right = std::max(right, c.x);
            top = std::max(top, c.z);
        }
    std::string outlines;
    for (const auto& stone : stones) {
        if (!outlines.empty()) outlines += "; ";
        for (std::size_t i = 0; i < stone.size(); ++i)
            outlines += (i > 0 ? ", " : "") + app::fixed(stone[i].x - left, decimals) + " " +
                        app::fixed(stone[i].z, decimals);
    }
    DrawnWall w;
    w.kind = kind;
    w.keys = "outlines = " + outlines + "\nthickness = " + metres(thickness) + " m\n";
    w.length = right - left;
    w.height = top;
    w.stones = static_cast<int>(stones.size());
    w.course_height = top / std::max(1.0, std::sqrt(static_cast<double>(w.stones)));
    w.thickness = thickness;
    return w;
}

namespace {

int draw_courses(Draw& d)
{
    if (d.chance(0.7)) return d.integer(1, 6);
    if (d.chance(0.7)) return d.integer(7, 15);
    return d.integer(16, 40);
}

std::string supports(Draw& d)
{
    const char* const base = d.one_of({"fixed", "joint"});
    const char* const toe = d.one_of({"held", "free"});
    return std::string("base = ") + base + "\ntoe = " + toe + "\n";
}

/// Keys of a wall in courses.
std::string course_keys(const DrawnWall& w, int courses)
{
    return "length = " + metres(w.length) + " m\ncourses = " + std::to_string(courses) +
           "\ncourse_height = " + metres(w.course_height) +
           " m\nunit_length = " + metres(w.unit) + " m\nthickness = " + metres(w.thickness) +
           " m\n";
}

std::string bond_keys(Draw& d)
{
    std::string keys = std::string("bond = ") +
                       d.one_of({"running", "running", "stack", "flemish", "0.3"}) + "\n";
    if (d.chance(0.2)) {
        keys += "unit_length_cov = " + app::fixed(d.uniform(0.05, 0.25), 2);
        keys += "\nseed = " + std::to_string(d.integer(1, 1000)) + "\n";
    }
    return keys + "first_course = " + d.one_of({"whole", "shifted"}) + "\n";
}

/// How many whole units make a length of `over` course heights: each 0.6 to 4 times as long as
/// high. 0: none.
int draw_units(double over, int courses, Draw& d)
{
    const int most = std::min(static_cast<int>(over / 0.6), (courses > 15 ? 60 : 30) / courses);
    const int least = std::max(1, static_cast<int>(std::ceil(over / 4.0)));
    if (least > most) return 0;
    const int one = d.integer(least, most), other = d.integer(least, most);
    return std::min(one, other);
}

DrawnWall draw_in_courses(const WallForm& form, Draw& d)
{
    const double over = form.courses / form.aspect; // length over course height
    const int units = std::max(1, draw_units(over, form.courses, d));
    DrawnWall w;
    w.kind = "courses";
    w.course_height = d.log_uniform(0.04, form.courses > 6 ? 0.10 : 0.25);
    w.length = over * w.course_height;
    w.height = form.courses * w.course_height;
    w.unit = w.length / (units - (units > 1 && d.chance(0.3) ? d.uniform(0.2, 0.8) : 0.0));
    w.thickness = d.uniform(0.1, 0.5);
    w.stones = form.courses * units;
    w.keys = course_keys(w, form.courses);
    w.keys += bond_keys(d);
    w.keys += supports(d);
    return w;
}

/// A door or a window, with or without a lintel.
DrawnWall draw_opening(Draw& d)
{
    DrawnWall w;
    w.kind = "opening";
    const int courses = d.integer(3, 6), units = d.integer(3, 4);
    w.course_height = d.uniform(0.06, 0.2);
    w.unit = w.course_height * d.uniform(1.2, 3.0);
    w.length = units * w.unit;
    w.height = courses * w.course_height;
    w.thickness = d.uniform(0.15, 0.5);
    w.stones = courses * units;
    const int wide = d.integer(1, units - 2), left = d.integer(1, units - 1 - wide);
    const int sill = d.chance(0.5) ? 0 : 1;
    const int high = d.integer(1, courses - 1 - sill);
    w.keys = course_keys(w, courses) + "openings = " + metres(left * w.unit) + " m, " +
             metres(sill * w.course_height) + " m, " + metres(wide * w.unit) + " m, " +
             metres(high * w.course_height) + " m\n";
    w.keys += supports(d);
    return w;
}

/// Courses whose bed joints slope and whose head joints lean, within straight or battered
/// sides.
DrawnWall draw_sloping(Draw& d)
{
    const int courses = d.integer(2, 5), units = d.integer(1, 3);
    const double h = d.uniform(0.05, 0.2), unit = h * d.uniform(1.0, 2.5);
    const double batter = d.chance(0.4) ? d.uniform(0.0, 0.1) : 0.0; // of both sides
    const double foot = units * unit, rise = courses * h;
    std::vector<std::vector<Corner>> stones;
    double slope = 0.0;
    for (int c = 0; c < courses; ++c) {
        const double next =
            c + 1 < courses ? d.uniform(-0.35, 0.35) * h / foot : 0.0; // the top is level
        const auto on = [&](double t, double z0, double tilt) {
            const double in = batter * z0;
            const double x = in + t * (foot - 2.0 * in);
            return Corner{x, z0 + tilt * (x - 0.5 * foot)};
        };
        double low = 0.0, high = 0.0;
        for (int u = 0; u < units; ++u) {
            const bool last = u + 1 == units;
            const double mid = (u + (c % 2 == 0 ? 0.8 : 1.2)) / units;
            const double to_low = last ? 1.0 : mid + d.uniform(-0.12, 0.12) / units;
            const double to_high = last ? 1.0 : mid + d.uniform(-0.12, 0.12) / units;
            stones.push_back({on(low, c * h, slope), on(to_low, c * h, slope),
                              on(to_high, (c + 1) * h, next), on(high, (c + 1) * h, next)});
            low = to_low;
            high = to_high;
        }
        slope = next;
    }
    DrawnWall w = drawn_wall_of("drawing", std::move(stones), d.uniform(0.15, 0.5), 14);
    w.course_height = rise / courses;
    return w;
}

std::vector<Corner> box(double x0, double z0, double x1, double z1)
{
    return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
}

/// Two piers, a flat arch of one stone or of three, and a course above.
DrawnWall draw_portal(Draw& d)
{
    const double pier = d.uniform(0.1, 0.4), gap = d.uniform(0.2, 0.8),
                 rise = d.uniform(0.2, 0.8), depth = d.uniform(0.1, 0.25);
    const int drums = d.integer(1, 3);
    const double length = 2.0 * pier + gap;
    std::vector<std::vector<Corner>> stones;
    for (const double x : {0.0, pier + gap})
        for (int i = 0; i < drums; ++i)
            stones.push_back(box(x, i * rise / drums, x + pier, (i + 1) * rise / drums));
    const double top = rise + depth;
    if (d.chance(0.5)) {
        stones.push_back(box(0.0, rise, length, top));
    } else { // the key stone leans on its neighbours
        const double half = 0.25 * gap, lean = d.uniform(0.1, 0.4) * depth, mid = 0.5 * length;
        stones.push_back(
            {{0.0, rise}, {mid - half, rise}, {mid - half - lean, top}, {0.0, top}});
        stones.push_back({{mid - half, rise},
                          {mid + half, rise},
                          {mid + half + lean, top},
                          {mid - half - lean, top}});
        stones.push_back(
            {{mid + half, rise}, {length, rise}, {length, top}, {mid + half + lean, top}});
    }
    const int above = d.integer(1, 3);
    const double course = d.uniform(0.1, 0.25);
    for (int i = 0; i < above; ++i)
        stones.push_back(box(i * length / above, top, (i + 1) * length / above, top + course));
    return drawn_wall_of("drawing", std::move(stones), d.uniform(0.2, 0.5));
}

DrawnWall draw_drawing(Draw& d)
{
    DrawnWall w = d.chance(0.65) ? draw_sloping(d) : draw_portal(d);
    w.keys += std::string("base = ") + d.one_of({"fixed", "joint"}) + "\n";
    return w;
}

DrawnWall draw_rubble(Draw& d)
{
    DrawnWall w;
    w.kind = "rubble";
    const int courses = d.integer(2, 4), across = d.integer(2, 4);
    w.course_height = d.uniform(0.06, 0.18);
    w.unit = w.course_height * d.uniform(1.2, 2.0);
    w.length = across * w.unit;
    w.height = courses * w.course_height;
    w.thickness = d.uniform(0.2, 0.5);
    w.stones = courses * across;
    w.keys = "bond = rubble\nseed = " + std::to_string(d.integer(1, 1000)) + "\n" +
             course_keys(w, courses);
    w.keys += std::string("base = ") + d.one_of({"fixed", "joint"}) + "\n";
    w.unit = 0.0; // no units that crack
    return w;
}

} // namespace

WallForm draw_form(Draw& d)
{
    WallForm f;
    const double which = d.uniform(0.0, 1.0);
    f.kind = which < 0.52   ? "courses"
             : which < 0.64 ? "opening"
             : which < 0.76 ? "drawing"
             : which < 0.90 ? "arch"
                            : "rubble";
    if (f.kind != "courses") return f;
    int units = 0;
    while (units == 0) {
        f.aspect = d.log_uniform(0.3, 6.0);
        f.courses = draw_courses(d);
        units = draw_units(f.courses / f.aspect, f.courses, d);
    }
    return f;
}

DrawnWall draw_wall(const WallForm& form, Draw& d)
{
    if (form.kind == "courses") return draw_in_courses(form, d);
    if (form.kind == "opening") return draw_opening(d);
    if (form.kind == "drawing") return draw_drawing(d);
    return form.kind == "arch" ? draw_arch(d) : draw_rubble(d);
}

} // namespace bench
