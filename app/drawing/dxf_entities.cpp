#include "app/drawing/dxf_entities.hpp"

#include "app/drawing/outlines/drawing_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace app {
namespace {

struct Remedy {
    std::string_view type, what;
};

// Entities that can be a stone, but have no straight sides of their own.
constexpr std::array kRefused = {
    Remedy{
        "ARC",
        "an arc; draw it as a polyline of straight pieces (FLATTEN or PEDIT in most programs)"},
    Remedy{"CIRCLE", "a circle; draw it as a polyline of straight pieces"},
    Remedy{"ELLIPSE", "an ellipse; draw it as a polyline of straight pieces"},
    Remedy{"SPLINE",
           "a spline; convert it to a polyline of straight pieces (PEDIT or FLATTEN)"},
    Remedy{"HELIX", "a helix; draw it as a polyline of straight pieces"},
    Remedy{
        "INSERT",
        "an inserted block; explode it (EXPLODE) so that its lines are in the drawing itself"},
    Remedy{"MLINE", "a multiline; explode it (EXPLODE)"},
    Remedy{"REGION", "a region; explode it (EXPLODE) into lines"},
    Remedy{"3DSOLID", "a solid body; draw its front as a polyline"},
    Remedy{"BODY", "a solid body; draw its front as a polyline"},
    Remedy{"SURFACE", "a surface; draw its front as a polyline"},
    Remedy{"MESH", "a mesh; draw its front as a polyline"},
    Remedy{"3DFACE", "a face in space; draw it as a polyline"},
    Remedy{"SOLID", "a filled area; draw its outline as a polyline"},
    Remedy{"TRACE", "a filled area; draw its outline as a polyline"},
};

struct Attributes {
    std::string layer;
    int flags = 0;          ///< group 70
    double extrusion = 1.0; ///< z of the normal: 1, or -1 where x is mirrored
};

/// The last group of this code; a null pointer if there is none.
const DxfGroup* find_group(const DxfEntity& entity, int code)
{
    const DxfGroup* found = nullptr;
    for (const DxfGroup& group : entity.groups)
        if (group.code == code) found = &group;
    return found;
}

double number_of(const DrawingFrame& frame, const DxfEntity& entity, int code, double otherwise)
{
    const DxfGroup* group = find_group(entity, code);
    return group ? dxf_number(frame, *group) : otherwise;
}

dem::Point point_of(const DrawingFrame& frame, const DxfEntity& entity, int x, int y)
{
    return checked_point(frame, entity.line, number_of(frame, entity, x, 0.0),
                         number_of(frame, entity, y, 0.0));
}

Attributes attributes_of(const DrawingFrame& frame, const DxfEntity& entity)
{
    Attributes a;
    if (const DxfGroup* layer = find_group(entity, 8)) a.layer = readable_name(layer->value);
    if (const DxfGroup* flags = find_group(entity, 70)) a.flags = dxf_integer(frame, *flags);
    const double nx = number_of(frame, entity, 210, 0.0),
                 ny = number_of(frame, entity, 220, 0.0);
    const double nz = number_of(frame, entity, 230, 1.0);
    if (std::hypot(nx, ny) > 1e-6 * std::abs(nz) || nz == 0.0) {
        refuse(frame, entity.line,
               entity.type + " is not drawn in the x-y plane; turn the wall into that plane");
    }
    a.extrusion = nz < 0 ? -1.0 : 1.0; // then the x axis of the entity points to the left
    return a;
}

void refuse_bulge(const DrawingFrame& frame, const DxfGroup& group, dem::Point at)
{
    // rise over half of the chord: programs that straighten arcs leave values such as 1e-12
    constexpr double kStraight = 1e-7;
    if (std::abs(dxf_number(frame, group)) <= kStraight) return;
    refuse(frame, group.line,
           "the side that begins at " + raw_coordinates(frame, at) +
               " is an arc (bulge); draw it as straight pieces (FLATTEN or PEDIT, Decurve)");
}

void refuse_height(const DrawingFrame& frame, int line, double a, double b)
{
    if (std::abs(a - b) <= 1e-6 * (1.0 + std::abs(a))) return;
    refuse(frame, line,
           "lines of the wall have different z; draw the wall flat in the x-y plane");
}

void add_light_polyline(DxfContent& content, const DxfEntity& entity)
{
    RawDrawing& drawing = content.drawing;
    const Attributes a = attributes_of(drawing.frame, entity);
    RawOutline outline{{}, a.layer, entity.line};
    double x = 0.0;
    bool has_x = false;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 10) {
            x = a.extrusion * dxf_number(drawing.frame, group);
            has_x = true;
        } else if (group.code == 20) {
            if (!has_x)
                refuse(drawing.frame, group.line,
                       "a corner has y and no x; save the drawing as DXF again");
            outline.corners.push_back(
                checked_point(drawing.frame, group.line, x, dxf_number(drawing.frame, group)));
            has_x = false;
        } else if (group.code == 42 && !outline.corners.empty()) {
            refuse_bulge(drawing.frame, group, outline.corners.back());
        }
    }
    if (has_x)
        refuse(drawing.frame, entity.line,
               "a corner has x and no y; save the drawing as DXF again");
    add_outline(drawing, std::move(outline), (a.flags & 1) != 0, content.snap);
}

void add_heavy_polyline(DxfContent& content, const DxfEntity& entity, DxfGroups& groups)
{
    RawDrawing& drawing = content.drawing;
    const DrawingFrame& frame = drawing.frame;
    const Attributes a = attributes_of(frame, entity);
    if ((a.flags & (2 | 4)) != 0) {
        refuse(frame, entity.line,
               "a polyline is smoothed to a curve; convert it to straight pieces (PEDIT, "
               "Decurve)");
    }
    if ((a.flags & (16 | 64)) != 0) {
        refuse(frame, entity.line,
               "a POLYLINE is a mesh in space; draw the fronts of the blocks as polylines");
    }
    RawOutline outline{{}, a.layer, entity.line};
    double height = 0.0;
    std::optional<DxfGroup> head;
    while ((head = groups.next())) {
        if (head->code != 0) continue;
        if (head->value != "VERTEX") break;
        const DxfEntity vertex = read_entity(groups, *head);
        const dem::Point at = point_of(frame, vertex, 10, 20);
        const double z = number_of(frame, vertex, 30, 0.0);
        if (outline.corners.empty()) height = z;
        refuse_height(frame, vertex.line, height, z);
        if (const DxfGroup* bulge = find_group(vertex, 42)) refuse_bulge(frame, *bulge, at);
        outline.corners.push_back({a.extrusion * at.x + 0.0, at.z});
    }
    if (head && head->value != "SEQEND") groups.step_back();
    add_outline(drawing, std::move(outline), (a.flags & 1) != 0, content.snap);
}

void add_straight(DxfContent& content, const DxfEntity& entity)
{
    const DrawingFrame& frame = content.drawing.frame;
    Attributes a;
    if (const DxfGroup* layer = find_group(entity, 8)) a.layer = readable_name(layer->value);
    refuse_height(frame, entity.line, number_of(frame, entity, 30, 0.0),
                  number_of(frame, entity, 31, 0.0));
    add_line(content.drawing, {point_of(frame, entity, 10, 20), point_of(frame, entity, 11, 21),
                               a.layer, entity.line});
}

/// Names of layers are the same in upper and lower case.
std::string upper_case(std::string_view name)
{
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return upper;
}

/// Name of the layer of an entity; without a group 8 it is on layer 0.
std::string_view layer_of(const DxfEntity& entity)
{
    const DxfGroup* layer = find_group(entity, 8);
    return layer ? layer->value : "0";
}

/// True for an entity that is invisible (group 60), or on a layer that is off or frozen; and
/// for what follows a polyline that was passed over.
bool count_hidden(DxfContent& content, const DxfEntity& entity)
{
    if (entity.type == "VERTEX" || entity.type == "SEQEND") return true;
    const DxfGroup* invisible = find_group(entity, 60);
    const std::string_view layer = layer_of(entity);
    if (content.hidden_layers.contains(upper_case(layer))) {
        ++content.hidden.on_layers[readable_name(layer)];
        return true;
    }
    if (!invisible || dxf_integer(content.drawing.frame, *invisible) != 1) return false;
    ++content.hidden.alone;
    return true;
}

} // namespace

DxfEntity read_entity(DxfGroups& groups, const DxfGroup& head)
{
    DxfEntity entity{std::string(head.value), head.line, {}};
    while (const std::optional<DxfGroup> group = groups.next()) {
        if (group->code == 0) {
            groups.step_back();
            break;
        }
        entity.groups.push_back(*group);
    }
    return entity;
}

void add_layer(DxfContent& content, const DxfEntity& layer)
{
    const DrawingFrame& frame = content.drawing.frame;
    const DxfGroup *name = find_group(layer, 2), *flags = find_group(layer, 70),
                   *colour = find_group(layer, 62);
    const bool frozen = flags && (dxf_integer(frame, *flags) & 1) != 0;
    const bool off = colour && dxf_integer(frame, *colour) < 0;
    if (name && (frozen || off)) content.hidden_layers.insert(upper_case(name->value));
}

void add_entity(DxfContent& content, const DxfEntity& entity, DxfGroups& groups)
{
    const DrawingFrame& frame = content.drawing.frame;
    const DxfGroup* space = find_group(entity, 67);
    if (space &&
        dxf_integer(frame, *space) == 1) { // vertices that follow are passed over as such
        ++content.in_paper_space;
        return;
    }
    if (count_hidden(content, entity)) return;
    const auto refused =
        std::ranges::find_if(kRefused, [&](const Remedy& r) { return r.type == entity.type; });
    if (refused != kRefused.end()) {
        refuse(frame, entity.line,
               "at " + raw_coordinates(frame, point_of(frame, entity, 10, 20)) + " there is " +
                   std::string(refused->what));
    }
    if (entity.type == "LWPOLYLINE") return add_light_polyline(content, entity);
    if (entity.type == "POLYLINE") return add_heavy_polyline(content, entity, groups);
    if (entity.type == "LINE") return add_straight(content, entity);
    ++content.ignored[readable_name(entity.type.substr(0, 40))];
}

} // namespace app
