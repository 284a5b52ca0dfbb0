#pragma once
/// The entities of a DXF file that are outlines, those that are passed over and those that are
/// refused.

#include "app/drawing/dxf_blocks.hpp"
#include "app/drawing/dxf_entity.hpp"
#include "app/drawing/outlines/hidden_layers.hpp"
#include "app/drawing/outlines/raw_drawing.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace app {

/// Content of a DXF that was read so far.
struct DxfContent {
    RawDrawing drawing;
    double snap = 0.0;                          ///< [m]
    std::map<std::string, std::size_t> ignored; ///< how many of each type
    std::size_t in_paper_space = 0;
    std::size_t arcs = 0;                ///< read as straight pieces
    std::set<std::string> hidden_layers; ///< off or frozen, in upper case
    std::set<std::string> frozen_layers; ///< those of them that are frozen
    HiddenShapes hidden;
    DxfBlocks blocks;
    DxfInsertion within; ///< what is read belongs to it
};

/// Keeps the layer of the table LAYER if it is off or frozen.
/// @throws ConfigError
void add_layer(DxfContent& content, const DxfEntity& layer);

/// Adds what the entity draws; of a POLYLINE its vertices too, which follow it in `groups`; of
/// an INSERT all that its block draws.
/// @throws ConfigError if it is a curve other than an arc, or not flat
void add_entity(DxfContent& content, const DxfEntity& entity, DxfGroups& groups);

} // namespace app
