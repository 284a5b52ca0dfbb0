#pragma once
/// Blocks of a DXF file: parts that are drawn once and inserted many times, as symbols and
/// stones are.

#include "app/drawing/dxf_entity.hpp"
#include "app/drawing/plane_transform.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace app {

struct DxfContent;

/// The definition of a block, in the section BLOCKS.
struct DxfBlock {
    std::string name;
    DxfGroups::Place first;   ///< of its entities
    dem::Point base;          ///< which comes to lie at the point of insertion
    bool is_external = false; ///< in another file
};

struct DxfBlocks {
    std::map<std::string, DxfBlock> defined;     ///< by their names in upper case
    std::map<std::string, std::size_t> inserted; ///< how many of each name
    std::size_t bytes = 0;                       ///< that were read for insertions
    std::size_t clipped = 0;                     ///< insertions of which only a part is shown
};

/// The insertions, one within the other, that an entity is read for; none in the drawing
/// itself.
struct DxfInsertion {
    PlaneTransform transform;       ///< from the axes of the block into those of the drawing
    std::string layer;              ///< which the layer 0 of the block stands for
    std::vector<std::string> names; ///< of the blocks, from the outermost one, in upper case
    int line = 0;                   ///< of the outermost INSERT; 0 in the drawing itself
};

/// Where a point of the block that is read comes to lie in the drawing.
/// @param line of the file, for messages
/// @throws ConfigError if its coordinates are no numbers a drawing can have
[[nodiscard]] dem::Point placed(const DxfContent& content, int line, dem::Point p);

/// Keeps the definition that begins with `block`, and reads to its end.
/// @throws ConfigError if it has no end
void add_block(DxfContent& content, const DxfEntity& block, DxfGroups& groups);

/// Adds all that the block of an INSERT draws, once for each row and column.
/// @param layer of the INSERT
/// @param groups is where it was, afterwards
/// @throws ConfigError if the file does not have the block, if it inserts itself, or if it
/// draws more than a wall can have
void insert_block(DxfContent& content, const DxfEntity& insert, const std::string& layer,
                  DxfGroups& groups);

/// Notes which blocks were inserted, and whether some are clipped.
void note_inserted(DxfContent& content);

} // namespace app
