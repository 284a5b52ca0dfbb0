#include "app/drawing/dxf_entities.hpp"

#include "app/drawing/outlines/arc_pieces.hpp"
#include "app/drawing/outlines/drawing_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace app {
namespace {

struct Remedy {
    std::string_view type, what;
};

// Entities that can be a stone, but have no straight sides of their own.
constexpr std::array kRefused = {
    Remedy{"CIRCLE", "a circle; draw it as a polyline of straight pieces"},
    Remedy{"ELLIPSE", "an ellipse; draw it as a polyline of straight pieces"},
    Remedy{"SPLINE",
           "a spline; convert it to a polyline of straight pieces (PEDIT or FLATTEN)"},
    Remedy{"HELIX", "a helix; draw it as a polyline of straight pieces"},
    Remedy{"MLINE", "a multiline; explode it (EXPLODE)"},
    Remedy{"MPOLYGON", "a polygon with a hatch; explode it (EXPLODE) into polylines"},
    Remedy{"REGION", "a region; explode it (EXPLODE) into lines"},
    Remedy{"3DSOLID", "a solid body; draw its front as a polyline"},
    Remedy{"BODY", "a solid body; draw its front as a polyline"},
    Remedy{"SURFACE", "a surface; draw its front as a polyline"},
    Remedy{"MESH", "a mesh; draw its front as a polyline"},
    Remedy{"3DFACE", "a face in space; draw it as a polyline"},
    Remedy{"SOLID", "a filled area; draw its outline as a polyline"},
    Remedy{"TRACE", "a filled area; draw its outline as a polyline"},
};

/// Name of the layer of an entity, empty if it has none. On layer 0 of a block it is on the
/// layer of the insertion.
std::string layer_of(const DxfContent& content, const DxfEntity& entity)
{
    const DxfGroup* layer = find_group(entity, 8);
    const bool has_own = layer && layer->value != "0";
    if (content.within.line > 0 && !has_own) return content.within.layer;
    return layer ? dxf_name(layer->value) : "";
}

void refuse_height(const DrawingFrame& frame, int line, double a, double b)
{
    if (std::abs(a - b) <= 1e-6 * (1.0 + std::abs(a))) return;
    refuse(frame, line,
           "lines of the wall have different z; draw the wall flat in the x-y plane");
}

/// Line that names an entity: of the entity, or of the insertion of its block.
int line_of(const DxfContent& content, int line)
{
    return content.within.line > 0 ? content.within.line : line;
}

/// A corner in the axes of its polyline.
struct DxfCorner {
    dem::Point at;
    int line = 0;       ///< of the file
    double bulge = 0.0; ///< of the side that begins here (arc_pieces.hpp)
};

/// Distance of straight pieces from their arc, in the drawing's unit: corners of other blocks
/// on the arc are then within snap of the pieces.
double off_arc(const DxfContent& content)
{
    return 0.5 * content.snap / content.drawing.frame.unit;
}

/// A chain of points as lines.
void add_lines(DxfContent& content, const std::vector<dem::Point>& chain,
               const DxfEntity& entity)
{
    for (std::size_t i = 1; i < chain.size(); ++i)
        add_line(content.drawing, {chain[i - 1], chain[i], layer_of(content, entity),
                                   line_of(content, entity.line)});
}

/// Adds an outline, or a side alone as lines.
void add_polyline(DxfContent& content, const DxfEntity& entity,
                  const std::vector<DxfCorner>& corners, bool closed)
{
    RawOutline outline{{}, layer_of(content, entity), entity.line};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const DxfCorner& c = corners[i];
        outline.corners.push_back(placed(content, c.line, c.at));
        if (i + 1 == corners.size() && !closed) break;
        const auto arc =
            bulge_points(c.at, corners[(i + 1) % corners.size()].at, c.bulge, off_arc(content));
        content.arcs += arc.empty() ? 0 : 1;
        for (const dem::Point p : arc) outline.corners.push_back(placed(content, c.line, p));
    }
    if (!closed && corners.size() == 2) return add_lines(content, outline.corners, entity);
    add_outline(content.drawing, std::move(outline), closed, content.snap);
    content.drawing.outlines.back().line = line_of(content, entity.line);
}

void add_light_polyline(DxfContent& content, const DxfEntity& entity)
{
    const DrawingFrame& frame = content.drawing.frame;
    const double extrusion = extrusion_of(frame, entity);
    std::vector<DxfCorner> corners;
    double x = 0.0;
    bool has_x = false;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 10) {
            x = extrusion * dxf_number(frame, group);
            has_x = true;
        } else if (group.code == 20) {
            if (!has_x)
                refuse(frame, group.line,
                       "a corner has y and no x; save the drawing as DXF again");
            corners.push_back({{x, dxf_number(frame, group)}, group.line});
            has_x = false;
        } else if (group.code == 42 && !corners.empty()) {
            corners.back().bulge = extrusion * dxf_number(frame, group);
        }
    }
    if (has_x)
        refuse(frame, entity.line, "a corner has x and no y; save the drawing as DXF again");
    add_polyline(content, entity, corners, (integer_of(frame, entity, 70, 0) & 1) != 0);
}

void refuse_no_polyline(const DrawingFrame& frame, const DxfEntity& entity, int flags)
{
    if ((flags & (2 | 4)) != 0) {
        refuse(frame, entity.line,
               "a polyline is smoothed to a curve; convert it to straight pieces (PEDIT, "
               "Decurve)");
    }
    if ((flags & (16 | 64)) != 0) {
        refuse(frame, entity.line,
               "a POLYLINE is a mesh in space; draw the fronts of the blocks as polylines");
    }
}

void add_heavy_polyline(DxfContent& content, const DxfEntity& entity, DxfGroups& groups)
{
    const DrawingFrame& frame = content.drawing.frame;
    const double extrusion = extrusion_of(frame, entity);
    const int flags = integer_of(frame, entity, 70, 0);
    refuse_no_polyline(frame, entity, flags);
    std::vector<DxfCorner> corners;
    double height = 0.0;
    std::optional<DxfGroup> head;
    while ((head = groups.next())) {
        if (head->code != 0) continue;
        if (head->value != "VERTEX") break;
        const DxfEntity vertex = read_entity(groups, *head);
        const dem::Point p = point_of(frame, vertex, 10, 20);
        const double z = number_of(frame, vertex, 30, 0.0);
        if (corners.empty()) height = z;
        refuse_height(frame, vertex.line, height, z);
        corners.push_back({{extrusion * p.x, p.z},
                           vertex.line,
                           extrusion * number_of(frame, vertex, 42, 0.0)});
    }
    if (head && head->value != "SEQEND") groups.step_back();
    add_polyline(content, entity, corners, (flags & 1) != 0);
}

void add_straight(DxfContent& content, const DxfEntity& entity)
{
    const DrawingFrame& frame = content.drawing.frame;
    refuse_height(frame, entity.line, number_of(frame, entity, 30, 0.0),
                  number_of(frame, entity, 31, 0.0));
    add_lines(content,
              {placed(content, entity.line, point_of(frame, entity, 10, 20)),
               placed(content, entity.line, point_of(frame, entity, 11, 21))},
              entity);
}

void add_arc(DxfContent& content, const DxfEntity& entity)
{
    const DrawingFrame& frame = content.drawing.frame;
    constexpr double kWhole = 360.0, kRadians = std::numbers::pi / 180.0; // of degrees
    const double extrusion = extrusion_of(frame, entity),
                 radius = number_of(frame, entity, 40, 0.0),
                 begin = number_of(frame, entity, 50, 0.0),
                 end = number_of(frame, entity, 51, kWhole),
                 turned = std::fmod(end - begin, kWhole);
    if (!(radius > 0.0)) refuse(frame, entity.line, "an arc has no radius; delete it");
    std::vector<dem::Point> chain;
    for (const dem::Point p :
         arc_points(point_of(frame, entity, 10, 20), radius, begin * kRadians,
                    (turned > 0.0 ? turned : turned + kWhole) * kRadians, off_arc(content)))
        chain.push_back(placed(content, entity.line, {extrusion * p.x, p.z}));
    ++content.arcs;
    add_lines(content, chain, entity);
}

/// True for an entity that is invisible (group 60), or on a layer that is off or frozen; and
/// for what follows a polyline that was passed over. An insertion on a layer that is off still
/// shows what its block has on other layers.
bool count_hidden(DxfContent& content, const DxfEntity& entity)
{
    if (entity.type == "VERTEX" || entity.type == "SEQEND") return true;
    const std::string own = layer_of(content, entity), layer = own.empty() ? "0" : own;
    const std::set<std::string>& hiding =
        entity.type == "INSERT" ? content.frozen_layers : content.hidden_layers;
    if (hiding.contains(upper_case(layer))) {
        ++content.hidden.on_layers[layer];
        return true;
    }
    if (integer_of(content.drawing.frame, entity, 60, 0) != 1) return false;
    ++content.hidden.alone;
    return true;
}

} // namespace

void add_layer(DxfContent& content, const DxfEntity& layer)
{
    const DrawingFrame& frame = content.drawing.frame;
    const DxfGroup *name = find_group(layer, 2), *flags = find_group(layer, 70),
                   *colour = find_group(layer, 62);
    const bool frozen = flags && (dxf_integer(frame, *flags) & 1) != 0;
    const bool off = colour && dxf_integer(frame, *colour) < 0;
    if (!name) return;
    const std::string known = upper_case(dxf_name(name->value));
    if (frozen || off) content.hidden_layers.insert(known);
    if (frozen) content.frozen_layers.insert(known);
}

void add_entity(DxfContent& content, const DxfEntity& entity, DxfGroups& groups)
{
    const DrawingFrame& frame = content.drawing.frame;
    if (integer_of(frame, entity, 67, 0) == 1) { // vertices that follow are passed over as such
        ++content.in_paper_space;
        return;
    }
    if (count_hidden(content, entity)) return;
    const auto refused =
        std::ranges::find_if(kRefused, [&](const Remedy& r) { return r.type == entity.type; });
    if (refused != kRefused.end()) {
        const dem::Point at = placed(content, entity.line, point_of(frame, entity, 10, 20));
        refuse(frame, entity.line,
               "at " + raw_coordinates(frame, at) + " there is " + std::string(refused->what));
    }
    if (entity.type == "LWPOLYLINE") return add_light_polyline(content, entity);
    if (entity.type == "POLYLINE") return add_heavy_polyline(content, entity, groups);
    if (entity.type == "LINE") return add_straight(content, entity);
    if (entity.type == "ARC") return add_arc(content, entity);
    if (entity.type == "INSERT")
        return insert_block(content, entity, layer_of(content, entity), groups);
    ++content.ignored[readable_name(entity.type.substr(0, 40))];
}

} // namespace app
