#include "app/scene/scene_command.hpp"

#include "app/drawing/write_drawing.hpp"
#include "app/input/key_effects.hpp"
#include "app/input/random_layouts.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/output/markup.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table.hpp"
#include "app/scene/bond_indices.hpp"
#include "app/scene/quality_terms.hpp"
#include "app/scene/reading_again.hpp"
#include "app/scene/scene_picture.hpp"
#include "app/scene/scene_units.hpp"
#include "app/study/wanted_walls.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/contact_count.hpp"
#include "dem/scene/layout.hpp"

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

std::string counted(std::size_t n, const std::string& one, const std::string& many)
{
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

std::string counted(int n, const std::string& one)
{
    return counted(static_cast<std::size_t>(n), one, one + 's');
}

/// "75 units in 120 blocks, 135 joints, 45 potential cracks, 1234 contact points"
std::string count_text(const Study& study, const dem::Layout& layout,
                       std::span<const DrawnBlock> units)
{
    std::string text = counted(units.size(), "unit", "units");
    if (static_cast<std::size_t>(layout.beam) != units.size())
        text += " in " + counted(layout.beam, "block");
    return text + ", " + counted(layout.n_joints, "joint") + ", " +
           counted(layout.n_cracks, "potential crack") + ", " +
           counted(dem::contact_count(layout, study.discretisation), "contact point",
                   "contact points");
}

/// Without the beam [m2], and its weight [N].
struct Masonry {
    double area = 0.0, weight = 0.0;
};

Masonry masonry_of(const Study& study, const dem::Layout& layout)
{
    Masonry m;
    for (std::size_t b = 0; b < static_cast<std::size_t>(layout.beam); ++b) {
        const dem::Block& block = layout.blocks[b];
        const dem::Elastic& stone = dem::stone_of(layout, static_cast<int>(b),
                                                  study.parameters.stone, study.beam.material);
        const double area = dem::area_of(block);
        m.area += area;
        m.weight += area * layout.thickness * stone.density * study.load.gravity;
    }
    return m;
}

std::string size_text(const Study& study, const dem::Layout& layout, const Masonry& m)
{
    return number(wall_length(study), 4) + " m long, " + number(layout.height, 4) +
           " m high, " + number(layout.thickness, 4) + " m thick; " + number(m.area, 4) +
           " m2 of stone, " + fixed(m.weight * 1e-3, 2) + " kN";
}

std::string whole_mm(double metres) { return fixed(metres * 1e3, 0); }

std::string index_text(const BondIndices& i)
{
    std::string text =
        "Mean unit " + whole_mm(i.mean_length) + " x " + whole_mm(i.mean_height) + " mm. ";
    text += std::isfinite(i.trace)
                ? "Line of minimum trace " + fixed(i.trace, 2) + " m, " +
                      fixed(i.trace_ratio, 2) + " times the height. "
                : "No line of minimum trace: no way through joints from the floor to the top. ";
    text += std::isfinite(i.mean_overlap)
                ? "Overlap of head joints in successive courses: mean " +
                      fixed(i.mean_overlap, 2) + ", least " + fixed(i.least_overlap, 2) +
                      " times the height of a unit."
                : "Overlap of head joints: not defined without rectangles in courses.";
    return text;
}

std::string_view word(Fulfilled f)
{
    return f == Fulfilled::fully    ? "fulfilled"
           : f == Fulfilled::partly ? "partly"
                                    : "not fulfilled";
}

std::string percent(double share) { return fixed(100.0 * share, 0) + " %"; }

std::string quality_text(const BondIndices& i, const QualityTerms& q)
{
    const std::string level = std::isfinite(i.level_trace_ratio)
                                  ? "minimum trace from side to side " +
                                        fixed(i.level_trace_ratio, 2) + " times the length"
                                  : "no way through joints from side to side";
    return "Of the masonry quality index: dimensions (SD) " + std::string(word(q.dimensions)) +
           ", " + percent(q.long_stones) + " of the units are longer than 400 mm, " +
           percent(q.middle_stones) + " 200 to 400 mm; head joints (VJ) " +
           std::string(word(q.staggered)) + "; for bed joints (HJ): " + level +
           "; for shapes (SS): units fill " + percent(q.filled) +
           " of their extents. SM, WC and MM are not seen in an elevation.";
}

constexpr std::string_view kSceneList = "drystone_scene_files.txt";

std::string layouts_text(const Study& study)
{
    if (!has_layouts(study)) return "";
    return "This is the layout of wall.seed = " + std::to_string(study.wall.seed) +
           ", the first of " + std::to_string(study.geometry.layouts) +
           "; --set wall.seed=K draws another.\n";
}

} // namespace

int scene_command(const Command& command)
{
    const StudySource source = study_source(command);
    const Study& study = source.study;
    const fs::path out = command.out;
    check_and_announce(out, {"scene.json", "scene.dxf", "scene.svg"}, command.quiet,
                       kSceneList);
    const dem::Layout layout = layout_of(study);
    const dem::Layout whole = whole_units(study);
    const std::vector<DrawnBlock> units = scene_units(study, whole);
    say_effects(study, command);
    const std::string counts = count_text(study, layout, units);
    const std::string sizes = size_text(study, layout, masonry_of(study, layout));
    const BondIndices indices = bond_indices(whole, units);
    const double unit = study.geometry.length_unit;
    write_results(out,
                  {{"scene.json", write_drawing_json(units, unit)},
                   {"scene.dxf", write_drawing_dxf(units, unit)},
                   {"scene.svg", scene_picture(layout, units, counts, sizes)}},
                  kSceneList);
    std::cout << wrapped(counts + ".\n", terminal_width())
              << wrapped(sizes + ".\n", terminal_width())
              << wrapped(index_text(indices) + "\n", terminal_width())
              << wrapped(quality_text(indices, quality_terms(indices, units)) + "\n",
                         terminal_width())
              << layouts_text(study) << "scene.svg, scene.json and scene.dxf written to "
              << command.out << '\n'
              << reading_again_text(study, layout.n_cracks > 0);
    return 0;
}

} // namespace app
