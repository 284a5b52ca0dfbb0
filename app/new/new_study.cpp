#include "app/new/new_study.hpp"

#include "app/input/study/material_presets.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr const char* kYours = "yours";

std::string line(std::string key, const std::string& value, const std::string& comment)
{
    constexpr std::size_t kValue = 17, kComment = 44;
    key.resize(std::max(key.size() + 1, kValue), ' ');
    std::string text = key + "= " + value;
    text.resize(std::max(text.size() + 1, kComment), ' ');
    return text + "# " + comment + '\n';
}

std::string metres(double x) { return number(x, 12) + " m"; }

/// The size that goes into a length a whole number of times, nearest to the one wanted.
double fitted(double length, double wanted)
{
    return length / std::max(1.0, std::round(length / wanted));
}

std::string whose(double wanted, double used, const std::string& fit)
{
    constexpr double kSame = 1e-9; // [m]
    if (std::abs(wanted - used) < kSame) return kYours;
    return "yours, " + metres(wanted) + ", fitted: " + fit;
}

std::string head(const Answers& a, const MaterialPreset& material, const std::string& path)
{
    return "# A wall of " + a.at("length") + " x " + a.at("height") + " x " +
           a.at("thickness") + ", of " + std::string(material.meaning) + ".\n#\n" +
           "# \"yours\": as you answered; \"choice\": the program's, look at it and change it; "
           "\"guess\": a value without a source at "
           "hand.\n"
           "# drystone scene " +
           path +
           "                  draws the wall\n"
           "# drystone push " +
           path +
           " --sample mean     pushes the wall of mean values\n"
           "# drystone study " +
           path +
           " --report         pushes random walls and writes tables and a page\n"
           "# drystone help KEY                        tells of a key, such as "
           "joint.cohesion\n\n";
}

std::string wall_lines(const Answers& a)
{
    const double length = parse_quantity(a.at("length"), "m");
    const double height = parse_quantity(a.at("height"), "m");
    const StoneSize stone = stone_size(a.at("unit"));
    const double wide = parse_quantity(stone.length, "m"),
                 high = parse_quantity(stone.height, "m");
    const bool halves = a.at("bond") == "running" || a.at("bond") == "stack";
    const double unit = halves ? 2.0 * fitted(length, 0.5 * wide) : wide;
    const double course = fitted(height, high);
    const bool rubble = a.at("bond") == "rubble";
    std::string text =
        "[wall]\n" + line("material", a.at("material"), "yours; gives the values below") +
        line("length", a.at("length"), kYours) +
        line("courses", number(std::round(height / course), 6),
             "to the height of " + a.at("height")) +
        line("course_height", metres(course),
             whose(high, course, "whole courses to the height")) +
        line("unit_length", metres(unit), whose(wide, unit, "whole halves to the length")) +
        line("thickness", a.at("thickness"), kYours) + line("bond", a.at("bond"), kYours) +
        line("base", "joint", "choice: the wall may lift off its foot and slide on it");
    if (!rubble) text += line("toe", "free", "choice: nothing holds the first course");
    if (a.at("openings") != "none")
        text += line("openings", a.at("openings"), "yours: x, z, width, height") +
                "\n[lintel]\n" + line("young_modulus", "10 GPa", "choice: timber") +
                line("density", "600 kg/m3", "choice: timber");
    return text;
}

/// Values of the material, to be replaced by one's own.
std::string material_lines(const MaterialPreset& material)
{
    std::string text = "\n# The values of the material. Take the # away and write your own "
                       "where you know better.\n";
    std::string section;
    for (const MaterialValue& v : material.values) {
        const std::string key(v.key), of = key.substr(0, key.find('.'));
        if (of != section) text += (section.empty() ? "[" : "\n[") + of + "]\n";
        section = of;
        text += line("# " + key.substr(of.size() + 1), std::string(v.value),
                     (v.guess ? "guess: " : "") + std::string(v.source));
    }
    return text;
}

std::string load_lines(const Answers& a)
{
    constexpr double kFarthest = 1.0; // [m], the most that load.max_displacement takes
    const double far = std::min(kFarthest, 0.7 * parse_quantity(a.at("length"), "m"));
    return "\n[beam]\n" +
           line("height", "0.20 m", "choice: a floor or ring beam, which is pushed") +
           line("young_modulus", "30 GPa", "choice: concrete") +
           line("density", "2500 kg/m3", "choice: concrete") + "\n[load]\n" +
           line("vertical_stress", a.at("stress"), kYours) +
           line("max_displacement", number(std::ceil(far * 1e3), 6) + " mm",
                "choice: far enough for a wall that rocks") +
           line("stop_below", "0.70", "choice: the drop to 80 % is known by then") +
           "\n[solver]\n" +
           line("kinematics", "finite", "choice: else a wall that rocks has no drift limit") +
           line("fidelity", "simple",
                "choice: stones simpler than standard, three times as quick") +
           "\n[output]\n" + line("snapshot_every", "5 mm", "choice") + "\n[uq]\n" +
           line("samples", "20", "choice: enough for a first look; 50 or more for a report") +
           line("seed", "1", "choice");
}

} // namespace

std::string new_study_text(const Answers& answers, const std::string& path)
{
    const MaterialPreset& material = *find_material(answers.at("material"));
    return head(answers, material, path) + wall_lines(answers) + material_lines(material) +
           load_lines(answers);
}

} // namespace app
