#pragma once
/// One entity of a DXF file: its type and its groups, and what all kinds of entities have.

#include "app/drawing/dxf_groups.hpp"
#include "app/drawing/outlines/raw_drawing.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace app {

struct DxfEntity {
    std::string type; ///< such as LWPOLYLINE
    int line = 0;     ///< of the type
    std::vector<DxfGroup> groups;
};

/// Reads the entity whose type is `head`, up to the next one.
/// @throws ConfigError
[[nodiscard]] DxfEntity read_entity(DxfGroups& groups, const DxfGroup& head);

/// The last group of this code; a null pointer if there is none.
[[nodiscard]] const DxfGroup* find_group(const DxfEntity& entity, int code);

/// The number of the last group of this code, or `otherwise`.
/// @throws ConfigError
[[nodiscard]] double number_of(const DrawingFrame& frame, const DxfEntity& entity, int code,
                               double otherwise);

/// The whole number of the last group of this code, or `otherwise`.
/// @throws ConfigError
[[nodiscard]] int integer_of(const DrawingFrame& frame, const DxfEntity& entity, int code,
                             int otherwise);

/// The point whose coordinates are the groups `x` and `y`, in the axes of the entity.
/// @throws ConfigError
[[nodiscard]] dem::Point point_of(const DrawingFrame& frame, const DxfEntity& entity, int x,
                                  int y);

/// The z of the normal of the entity: 1, or -1 where its x axis points to the left.
/// @throws ConfigError if it is not drawn in the x-y plane
[[nodiscard]] double extrusion_of(const DrawingFrame& frame, const DxfEntity& entity);

/// A name as people see it, in UTF-8: `\U+00FC` is the letter u with two dots. Bytes that are
/// not UTF-8 are taken as those of the code page ANSI_1252, which most files before 2007 have.
[[nodiscard]] std::string dxf_name(std::string_view value);

/// The name in upper case: names of layers and blocks are the same in upper and lower case.
[[nodiscard]] std::string upper_case(std::string_view name);

} // namespace app
