#include "app/commands.hpp"
#include "app/input/study_reading.hpp"

#include "app/drawing/write_drawing.hpp"
#include "app/input/key_effects.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/cells.hpp"
#include "app/output/table/table.hpp"
#include "app/sampling/wall_sites.hpp"
#include "app/scene/law_picture.hpp"
#include "app/scene/reading_again.hpp"
#include "app/scene/scene_picture.hpp"
#include "app/scene/scene_units.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/block/contact_count.hpp"
#include "dem/scene/bond_indices.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/mechanism/quality_terms.hpp"
#include "dem/scene/mechanism/rigid_wall.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>
#include <vector>

namespace app {
namespace {

namespace fs = std::filesystem;

std::string plural(int n, const std::string& one)
{
    return counted(static_cast<std::size_t>(n), one, one + 's');
}

/// "75 units in 120 blocks, 135 joints, 45 potential cracks, 1234 contact points"
std::string count_text(const dem::Discretisation& discretisation, const dem::Layout& layout,
                       std::span<const DrawnBlock> units)
{
    std::string text = counted(units.size(), "unit", "units");
    if (static_cast<std::size_t>(layout.beam) != units.size())
        text += " in " + plural(layout.beam, "block");
    return text + ", " + plural(layout.n_joints, "joint") + ", " +
           plural(layout.n_cracks, "potential crack") + ", " +
           counted(dem::contact_count(layout, discretisation), "contact point",
                   "contact points");
}

std::string size_text(const Masonry& masonry, const LoadInput& load, const dem::Layout& layout)
{
    const dem::Weights w =
        dem::weights_of(layout, masonry.parameters.stone, masonry.beam.material, load.gravity);
    return number(wall_length(masonry), 4) + " m long, " + number(layout.height, 4) +
           " m high, " + number(layout.thickness, 4) + " m thick; " + number(w.area, 4) +
           " m2 of stone, " + fixed(w.masonry * 1e-3, 2) + " kN";
}

std::string whole_mm(double metres) { return fixed(metres * 1e3, 0); }

std::string index_text(const dem::BondIndices& i)
{
    std::string text = "The mean unit is " + whole_mm(i.mean_length) + " x " +
                       whole_mm(i.mean_height) + " mm. ";
    text += std::isfinite(i.trace)
                ? "The line of minimum trace is " + fixed(i.trace, 2) + " m long, " +
                      fixed(i.trace_ratio, 2) + " times the height. "
                : "There is no line of minimum trace: no way leads through joints from the "
                  "floor to the top. ";
    text += std::isfinite(i.mean_overlap)
                ? "The overlap of head joints in successive courses is " +
                      fixed(i.mean_overlap, 2) +
                      " times the height of a unit on average, and " +
                      fixed(i.least_overlap, 2) + " times at least."
                : "The overlap of head joints is not defined without rectangles in courses.";
    return text;
}

std::string_view word(dem::Fulfilled f)
{
    return f == dem::Fulfilled::fully    ? "fulfilled"
           : f == dem::Fulfilled::partly ? "partly"
                                         : "not fulfilled";
}

std::string percent(double share) { return fixed(100.0 * share, 0) + " %"; }

std::string quality_text(const dem::BondIndices& i, const dem::QualityTerms& q)
{
    const std::string level = std::isfinite(i.level_trace_ratio)
                                  ? "the minimum trace from side to side is " +
                                        fixed(i.level_trace_ratio, 2) + " times the length"
                                  : "no way leads through joints from side to side";
    return "Terms of the masonry quality index: dimensions (SD): " +
           std::string(word(q.dimensions)) + " (" + percent(q.long_stones) +
           " of the units are longer than 400 mm, " + percent(q.middle_stones) +
           " are 200 to 400 mm long); head joints (VJ): " + std::string(word(q.staggered)) +
           "; bed joints (HJ): " + level + "; shapes (SS): the units fill " +
           percent(q.filled) +
           " of their extents. SM, WC and MM cannot be seen in an elevation.";
}

constexpr std::string_view kSceneList = "drystone_scene_files.txt";

/// Which value of a joint or a crack is which: the numbers behind "joint.friction_angle.17".
Table joint_table(const dem::Layout& layout)
{
    Table t;
    t.head = {"kind", "id", "course", "unit", "x [m]", "z [m]", "length [m]"};
    for (const auto& places : {joint_places(layout), crack_places(layout)})
        for (std::size_t i = 0; i < places.size(); ++i) {
            const JointPlace& p = places[i];
            t.rows.push_back({std::string(kind_name(p.kind)), count(static_cast<double>(i + 1)),
                              count(p.site.course), count(p.site.unit), Number{p.site.x},
                              Number{p.site.z}, Number{p.length}});
        }
    return t;
}

std::string layouts_text(const Masonry& masonry)
{
    if (!has_layouts(masonry.geometry)) return "";
    return "This is the layout of wall.seed = " + std::to_string(masonry.wall.seed) +
           ", the first of " + std::to_string(masonry.geometry.layouts) +
           "; --set wall.seed=K draws another.\n";
}

} // namespace

int scene_command(const Command& command)
{
    const StudySource source = study_source(command.study, command.overrides, Purpose::drawing);
    const Study& study = source.ready.study;
    const fs::path out = command.out;
    if (const std::string note = check_results(
            out, {"scene.json", "scene.dxf", "scene.svg", "joints.csv", "laws.svg"},
            kSceneList);
        !command.quiet)
        std::cerr << note;
    const dem::Layout& layout = source.ready.layout;
    const dem::Layout whole = whole_units(study, study.source);
    const std::vector<DrawnBlock> units = scene_units(study.geometry, whole);
    std::cerr << study_notes(source.ready, command.verb);
    if (!study.load.unfit_height.empty())
        std::cerr << "note: load.height: " << study.load.unfit_height
                  << ". The wall is drawn; push and study refuse it.\n";
    const std::string counts = count_text(study.discretisation, layout, units);
    const std::string sizes = size_text(study, study.load, layout);
    const dem::BondIndices indices = dem::bond_indices(whole);
    const double unit = study.geometry.length_unit;
    write_results(
        out,
        {{"scene.json", write_drawing_json(units, unit)},
         {"scene.dxf", write_drawing_dxf(units, unit)},
         {"scene.svg", scene_picture(layout, units, counts, sizes)},
         {"joints.csv", as_csv(joint_table(layout))},
         {"laws.svg", law_picture(study.parameters, layout.course_height,
                                  stress_level(study.load, 0), layout, study.solver)}},
        kSceneList);
    std::cout << wrapped(counts + ".\n", terminal_width())
              << wrapped(sizes + ".\n", terminal_width())
              << wrapped(index_text(indices) + "\n", terminal_width())
              << wrapped(quality_text(indices, dem::quality_terms(indices, whole)) + "\n",
                         terminal_width())
              << layouts_text(study)
              << "scene.svg, laws.svg, scene.json, scene.dxf and joints.csv written to "
              << command.out << '\n'
              << reading_again_text(study, layout.n_cracks > 0);
    return 0;
}

} // namespace app
