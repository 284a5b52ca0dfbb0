#pragma once
/// The entities of a DXF file that are outlines, those that are passed over and those that are
/// refused.

#include "app/drawing/dxf_groups.hpp"
#include "app/drawing/hidden_layers.hpp"
#include "app/drawing/outlines/raw_drawing.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace app {

struct DxfEntity {
    std::string type; ///< such as LWPOLYLINE
    int line = 0;     ///< of the type
    std::vector<DxfGroup> groups;
};

/// Content of a DXF that was read so far.
struct DxfContent {
    RawDrawing drawing;
    double snap = 0.0;                          ///< [m]
    std::map<std::string, std::size_t> ignored; ///< how many of each type
    std::size_t in_paper_space = 0;
    std::set<std::string> hidden_layers; ///< off or frozen, in upper case
    HiddenShapes hidden;
};

/// Reads the entity whose type is `head`, up to the next one.
/// @throws ConfigError
[[nodiscard]] DxfEntity read_entity(DxfGroups& groups, const DxfGroup& head);

/// Keeps the layer of the table LAYER if it is off or frozen.
/// @throws ConfigError
void add_layer(DxfContent& content, const DxfEntity& layer);

/// Adds what the entity draws; of a POLYLINE its vertices too, which follow it in `groups`.
/// @throws ConfigError if it is curved, not flat, or an insertion of a block
void add_entity(DxfContent& content, const DxfEntity& entity, DxfGroups& groups);

} // namespace app
