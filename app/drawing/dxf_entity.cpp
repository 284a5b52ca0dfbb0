#include "app/drawing/dxf_entity.hpp"

#include "app/drawing/outlines/drawing_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace app {

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

int integer_of(const DrawingFrame& frame, const DxfEntity& entity, int code, int otherwise)
{
    const DxfGroup* group = find_group(entity, code);
    return group ? dxf_integer(frame, *group) : otherwise;
}

dem::Point point_of(const DrawingFrame& frame, const DxfEntity& entity, int x, int y)
{
    return checked_point(frame, entity.line, number_of(frame, entity, x, 0.0),
                         number_of(frame, entity, y, 0.0));
}

double extrusion_of(const DrawingFrame& frame, const DxfEntity& entity)
{
    const double nx = number_of(frame, entity, 210, 0.0),
                 ny = number_of(frame, entity, 220, 0.0);
    const double nz = number_of(frame, entity, 230, 1.0);
    if (std::hypot(nx, ny) > 1e-6 * std::abs(nz) || nz == 0.0) {
        refuse(frame, entity.line,
               entity.type + " is not drawn in the x-y plane; turn the wall into that plane");
    }
    return nz < 0 ? -1.0 : 1.0;
}

std::string dxf_name(std::string_view value) { return readable_name(value); }

std::string upper_case(std::string_view name)
{
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return upper;
}

} // namespace app
