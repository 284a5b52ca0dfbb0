#include "app/input/wall/wall_geometry.hpp"

#include "app/drawing/outlines/drawing.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/built_wall.hpp"
#include "app/input/wall/drawn_ends.hpp"
#include "app/input/wall/layer_stones.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/text/check_sum.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/bond.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>

namespace app {
namespace {

double parse_coordinate(std::string_view text)
{
    double x = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (error != std::errc() || end != text.data() + text.size() || !(std::abs(x) < 1e4))
        throw BadValue(in_quotes(text) + " is not a coordinate in metres");
    return x;
}

dem::Point parse_corner(std::string_view text)
{
    const std::size_t blank = text.find_first_of(" \t");
    if (blank == std::string_view::npos)
        throw BadValue(in_quotes(text) + " is not a corner; write x and z in metres: 0.2 0.1");
    return {parse_coordinate(text.substr(0, blank)),
            parse_coordinate(trimmed(text.substr(blank)))};
}

/// 0 where the layer is of the wall's own stone.
int material_of(const std::vector<std::string>& layers, std::string_view layer)
{
    const auto at = std::ranges::find(layers, layer);
    return at == layers.end() ? 0 : 1 + static_cast<int>(at - layers.begin());
}

/// Lintels, which never crack, in drawings and where `scene` exports a wall in courses: the
/// layer "lintel" or "Lintel". 0 where no layer is.
int lintels_of(const std::vector<std::string>& layers)
{
    const auto at = std::ranges::find(layers, "lintel", lower_case);
    return at == layers.end() ? 0 : 1 + static_cast<int>(at - layers.begin());
}

/// From 1; 0 of a unit without a layer.
int layer_number(std::vector<std::string>& layers, const std::string& layer)
{
    if (layer.empty()) return 0;
    const auto at = std::ranges::find(layers, layer) - layers.begin();
    if (at == std::ssize(layers)) layers.push_back(layer);
    return 1 + static_cast<int>(at);
}

std::vector<dem::DrawnUnit> parse_outlines(GeometryInput& g)
{
    std::vector<dem::DrawnUnit> units;
    for (const std::string_view part : split(g.outlines, ";")) {
        const auto [layer, corners] = named_part(part);
        dem::DrawnUnit unit;
        unit.material = material_of(g.layers, layer);
        unit.layer = layer_number(g.drawn_layers, layer);
        for (const std::string_view corner : split(corners, ","))
            unit.outline.push_back(parse_corner(corner));
        if (unit.outline.size() < 3 || !(dem::polygon_area(unit.outline) > 0.0))
            throw BadValue(in_quotes(part) +
                           " is not an outline; it needs three corners, counter-clockwise");
        units.push_back(std::move(unit));
    }
    return units;
}

std::filesystem::path path_of(const GeometryInput& geometry, const StudyFile& source)
{
    return path_from(source, "wall.geometry", geometry.file);
}

/// One spelling of each layer, that of the study if it names the layer: CAD programs do not
/// tell "Lintel" from "LINTEL".
void spell_layers(Drawing& drawing, std::vector<std::string> spellings)
{
    for (DrawnBlock& b : drawing.blocks) {
        const auto known = std::ranges::find(spellings, lower_case(b.layer), lower_case);
        if (known == spellings.end())
            spellings.push_back(b.layer);
        else
            b.layer = *known;
    }
}

void read_file(Study& study)
{
    GeometryInput& g = study.geometry;
    const std::filesystem::path path = path_of(study.geometry, study.source);
    if (is_picture(path))
        for (const auto& [key, size] : {std::pair{"wall.picture_width", g.picture_width},
                                        std::pair{"wall.picture_height", g.picture_height}})
            if (size == 0.0)
                throw error_at(
                    study.source, key,
                    "missing; a picture does not say its size: write for example 1.20 m");
    const bool unit_given = find_entry(study.source, "wall.length_unit") != nullptr;
    Drawing drawing = read_drawing(path, {g.length_unit, unit_given, g.snap, g.close_outlines,
                                          g.picture_width, g.picture_height, g.simplify});
    if (lower_case(path.extension().string()) == ".dxf") spell_layers(drawing, g.layers);
    g.notes = drawing.notes;
    if (std::string note = layers_note(drawing, g.layers); !note.empty())
        g.notes.push_back(std::move(note));
    for (const DrawnBlock& b : drawing.blocks)
        g.units.push_back(
            {b.outline, material_of(g.layers, b.layer), layer_number(g.drawn_layers, b.layer)});
    for (const std::string& layer : g.layers)
        if (std::ranges::none_of(drawing.blocks,
                                 [&](const DrawnBlock& b) { return b.layer == layer; }))
            throw error_at(study.source, "wall.layer_stones",
                           "the drawing has no layer " + in_quotes(layer) +
                               (is_picture(path) ? "; a picture has none: draw the wall"
                                                 : layers_text(drawing)));
}

/// Outlines of the study itself are fitted and checked as those of a drawing are.
void fit_outlines(Study& study)
{
    const Entry* entry = find_entry(study.source, "wall.outlines");
    std::vector<DrawnBlock> blocks;
    for (const dem::DrawnUnit& unit : study.geometry.units)
        blocks.push_back({unit.outline, ""});
    Drawing drawing = fit_blocks(study.source.path, entry->line, blocks);
    for (std::size_t b = 0; b < drawing.blocks.size(); ++b)
        study.geometry.units[b].outline = std::move(drawing.blocks[b].outline);
    study.geometry.notes = std::move(drawing.notes);
}

std::string outline_text(const dem::DrawnUnit& unit)
{
    std::string text;
    for (const dem::Point p : unit.outline)
        text += (text.empty() ? "" : ", ") + number(p.x, 17) + " " + number(p.z, 17);
    return text;
}

dem::DrawnWall drawn_wall(const Masonry& masonry, const StudyFile& source)
{
    dem::DrawnWall wall;
    wall.units = masonry.geometry.units;
    wall.stones = masonry.geometry.stones;
    wall.lintels = lintels_of(masonry.geometry.layers);
    wall.thickness = masonry.wall.thickness;
    wall.base = masonry.wall.base;
    const bool given = find_entry(source, "wall.unit_length") != nullptr;
    wall.unit_length = given ? masonry.wall.unit_length : 0.0;
    wall.cracks = masonry.wall.cracks;
    return wall;
}

double beam_height(const dem::Beam& beam) { return beam.present ? beam.height : 0.0; }

} // namespace

bool is_drawn(const GeometryInput& geometry)
{
    return !geometry.units.empty() && !geometry.rubble;
}

std::string_view geometry_key(const GeometryInput& g)
{
    return !g.file.empty() ? "wall.geometry" : !g.outlines.empty() ? "wall.outlines" : "wall";
}

bool in_courses(const GeometryInput& g)
{
    return g.file.empty() && g.outlines.empty() && !g.rubble;
}

void require_joints(const GeometryInput& geometry, const StudyFile& source,
                    const dem::Layout& layout)
{
    std::vector<char> has(layout.blocks.size());
    for (const dem::Face& f : layout.faces)
        for (const int block : {f.a, f.b})
            if (block != dem::kGround) has[static_cast<std::size_t>(block)] = 1;
    const auto alone = std::ranges::find(has, 0);
    if (alone == has.end()) return;
    const auto b = static_cast<std::size_t>(alone - has.begin());
    const dem::Block& block = layout.blocks[b];
    const dem::Point at = dem::centre_of(block);
    const std::string name =
        static_cast<int>(b) == layout.beam
            ? "the beam"
            : "the block at (" + number(at.x, 4) + ", " + number(at.z, 4) + ")";
    if (block.motion != dem::Motion::free)
        throw error_at(source, "wall.base",
                       "fixed holds " + name +
                           ", which touches no other, so that nothing of it can move; write "
                           "joint, or leave the block out");
    throw error_at(source, geometry_key(geometry),
                   name + " lies against no other over more than " +
                       number(1e3 * dem::kShortestFace, 3) +
                       " mm; draw it against its neighbours");
}

void read_geometry(Study& study)
{
    GeometryInput& g = study.geometry;
    const std::string_view key = geometry_key(study.geometry);
    if (g.file.empty() && g.outlines.empty()) {
        read_built_wall(study);
        return;
    }
    if (!g.file.empty() && !g.outlines.empty())
        throw error_at(study.source, "wall.outlines",
                       "wall.geometry draws the wall too; remove one of them");
    read_at(study.source, "wall.layer_stones", [&] { parse_layer_stones(study); });
    read_at(study.source, key, [&] {
        if (g.file.empty()) {
            g.units = parse_outlines(g);
            fit_outlines(study);
        } else {
            read_file(study);
        }
        read_unit_cracks(study);
        require_level_top(study);
        std::ranges::copy(notes_of_ends(study), std::back_inserter(g.notes));
        check_pieces_of_units(study, study.source);
        const dem::Layout layout =
            dem::drawn_layout(drawn_wall(study, study.source), beam_height(study.beam));
        require_joints(study.geometry, study.source, layout);
        if (find_entry(study.source, "wall.course_height") == nullptr)
            study.wall.course_height = layout.course_height;
        study.cracks.cut_nothing = layout.n_cracks == 0;
    });
}

dem::Region wall_extent(const Masonry& masonry)
{
    if (!is_drawn(masonry.geometry))
        return {0.0, 0.0, masonry.wall.length,
                dem::top_of_course(masonry.wall, masonry.wall.courses)};
    const std::vector<dem::DrawnUnit>& units = masonry.geometry.units;
    dem::Region all = dem::extent_of(units.front().outline);
    for (const dem::DrawnUnit& unit : units) all = dem::join(all, dem::extent_of(unit.outline));
    return all;
}

double wall_length(const Masonry& masonry)
{
    if (!is_drawn(masonry.geometry)) return masonry.wall.length;
    const dem::Region all = wall_extent(masonry);
    return all.x1 - all.x0;
}

double wall_height(const Masonry& masonry) { return wall_extent(masonry).z1; }

bool has_mortar(const JointInput& joint)
{
    return joint.tensile_strength > 0.0 || joint.cohesion > 0.0;
}

bool has_crushing(const Parameters& p, bool units_crack)
{
    return p.joint.crushing.strength > 0.0 || (units_crack && p.unit.crushing.strength > 0.0);
}

std::string_view mixed_mode_key(const Parameters& p, bool units_crack)
{
    constexpr auto kHyperbolic = dem::Envelope::hyperbolic;
    if (units_crack && p.unit.envelope == kHyperbolic) return "unit.envelope";
    if (units_crack && p.unit.shear_fracture_energy > 0.0) return "unit.shear_fracture_energy";
    if (!has_mortar(p.joint)) return "";
    if (p.joint.envelope == kHyperbolic) return "joint.envelope";
    if (p.joint.shear_fracture_energy > 0.0) return "joint.shear_fracture_energy";
    return "";
}

bool is_full_rectangle(const Masonry& masonry)
{
    if (!is_drawn(masonry.geometry)) return masonry.wall.openings.empty();
    constexpr double kRounding = 1e-9; // of the area
    const dem::Region all = wall_extent(masonry);
    double area = 0.0;
    for (const dem::DrawnUnit& unit : masonry.geometry.units) {
        if (unit.material != 0) return false;
        area += dem::polygon_area(unit.outline);
    }
    return area >= (1.0 - kRounding) * (all.x1 - all.x0) * (all.z1 - all.z0);
}

dem::Layout laid_units(const Masonry& masonry, const StudyFile& source)
{
    dem::Layout layout =
        !masonry.geometry.units.empty()
            ? dem::drawn_layout(drawn_wall(masonry, source), beam_height(masonry.beam))
            : dem::lay_out(masonry.wall, beam_height(masonry.beam));
    layout.course_height = masonry.wall.course_height; // h of Eq. 2
    return layout;
}

dem::Layout whole_units(Masonry masonry, const StudyFile& source)
{
    masonry.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    masonry.wall.cracks.where.clear();
    return laid_units(masonry, source);
}

dem::Layout layout_of(const Masonry& masonry, const StudyFile& source)
{
    dem::Layout layout = laid_units(masonry, source);
    const JointInput& joint = masonry.parameters.joint;
    layout.mortar = has_mortar(joint);
    const bool units_crack = has_cracks(masonry, source);
    layout.crushing = has_crushing(masonry.parameters, units_crack);
    layout.wear = joint.wear_length > 0.0;
    layout.closure = joint.closure;
    layout.mixed_mode = !mixed_mode_key(masonry.parameters, units_crack).empty();
    return layout;
}

std::string outlines_text(const GeometryInput& g)
{
    std::string text;
    for (const dem::DrawnUnit& unit : g.units) {
        if (!text.empty()) text += "; ";
        if (unit.material > 0) text += g.layers[unit.material - 1] + ": ";
        text += outline_text(unit);
    }
    return text;
}

std::string outlines_mark(const GeometryInput& geometry)
{
    return std::to_string(geometry.units.size()) + " outlines, " +
           check_sum(outlines_text(geometry));
}

} // namespace app
