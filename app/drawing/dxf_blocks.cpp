#include "app/drawing/dxf_blocks.hpp"

#include "app/drawing/dxf_entities.hpp"
#include "app/drawing/outlines/drawing_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace app {
namespace {

constexpr std::size_t kDeepestInsertion = 64;  // insertions one within the other
constexpr std::size_t kMostBytes = 50'000'000; // read for insertions; 20 000 stones take 1e7
constexpr std::size_t kLeastBytes = 200;       // that an insertion counts as

/// A turn by an angle in degrees; quarters of a turn are exact.
PlaneTransform turned_by(double degrees)
{
    const double angle = std::fmod(degrees, 360.0);
    const double quarters = angle / 90.0;
    double c = std::cos(angle * std::numbers::pi / 180.0),
           s = std::sin(angle * std::numbers::pi / 180.0);
    if (quarters == std::floor(quarters)) {
        c = std::round(c) + 0.0;
        s = std::round(s) + 0.0;
    }
    return {c, s, -s, c, 0.0, 0.0};
}

PlaneTransform moved_by(double x, double y) { return {1.0, 0.0, 0.0, 1.0, x, y}; }

std::string inserted_at(const DxfContent& content, const DxfEntity& insert,
                        const std::string& name)
{
    const DrawingFrame& frame = content.drawing.frame;
    const dem::Point p = point_of(frame, insert, 10, 20);
    const dem::Point at =
        placed(content, insert.line, {extrusion_of(frame, insert) * p.x, p.z});
    return "at " + raw_coordinates(frame, at) + " the block \"" + name + "\" is inserted";
}

/// The block of an INSERT.
const DxfBlock& block_of(const DxfContent& content, const DxfEntity& insert,
                         const std::string& name)
{
    const DrawingFrame& frame = content.drawing.frame;
    const auto known = content.blocks.defined.find(upper_case(name));
    if (known == content.blocks.defined.end()) {
        refuse(frame, insert.line,
               inserted_at(content, insert, name) +
                   ", which the file does not define; save the drawing as DXF again with its "
                   "blocks, or explode it (EXPLODE)");
    }
    if (known->second.is_external) {
        refuse(frame, insert.line,
               inserted_at(content, insert, name) +
                   ", which is in another file (external reference); bind it (XREF, Bind), and "
                   "save the drawing as DXF again");
    }
    const std::vector<std::string>& names = content.within.names;
    if (std::ranges::find(names, known->first) != names.end()) {
        refuse(frame, insert.line,
               inserted_at(content, insert, name) +
                   " within itself, so that it would have no end; delete this insertion");
    }
    if (names.size() >= kDeepestInsertion) {
        refuse(frame, insert.line,
               inserted_at(content, insert, name) + ", more than " +
                   std::to_string(kDeepestInsertion) +
                   " insertions deep; explode the drawing (EXPLODE)");
    }
    return known->second;
}

/// Rows and columns of an INSERT, each at a place of its own.
struct Grid {
    int columns = 1, rows = 1;
    double across = 0.0, up = 0.0; ///< between two of them, in the drawing's unit
};

Grid grid_of(const DrawingFrame& frame, const DxfEntity& insert)
{
    return {std::max(1, integer_of(frame, insert, 70, 1)),
            std::max(1, integer_of(frame, insert, 71, 1)), number_of(frame, insert, 44, 0.0),
            number_of(frame, insert, 45, 0.0)};
}

/// Places the axes of an insertion, turned, into those around it.
PlaneTransform place_of(const DrawingFrame& frame, const DxfEntity& insert)
{
    const dem::Point at = point_of(frame, insert, 10, 20);
    const PlaneTransform seen{extrusion_of(frame, insert), 0.0, 0.0, 1.0, 0.0, 0.0};
    return seen * moved_by(at.x, at.z) * turned_by(number_of(frame, insert, 50, 0.0));
}

/// Scales a block about its base point.
PlaneTransform shape_of(const DxfContent& content, const DxfEntity& insert,
                        const DxfBlock& block)
{
    const DrawingFrame& frame = content.drawing.frame;
    const double x = number_of(frame, insert, 41, 1.0), y = number_of(frame, insert, 42, 1.0);
    if (x == 0.0 || y == 0.0) {
        refuse(frame, insert.line,
               inserted_at(content, insert, block.name) +
                   " with a scale of 0; give it a size or delete it");
    }
    return PlaneTransform{x, 0.0, 0.0, y, 0.0, 0.0} * moved_by(-block.base.x, -block.base.z);
}

/// Adds the entities of a block once.
void add_content(DxfContent& content, const DxfBlock& block, const DxfEntity& insert,
                 DxfGroups& groups)
{
    content.blocks.bytes += kLeastBytes;
    groups.go_to(block.first);
    std::size_t from = groups.place().at;
    while (const std::optional<DxfGroup> head = groups.next()) {
        const bool ends = head->code == 0 && head->value == "ENDBLK";
        if (head->code == 0 && !ends) add_entity(content, read_entity(groups, *head), groups);
        content.blocks.bytes += groups.place().at - from;
        from = groups.place().at;
        if (content.blocks.bytes > kMostBytes) {
            refuse(
                content.drawing.frame, insert.line,
                inserted_at(content, insert, block.name) +
                    ", and all insertions so far draw more than a wall can have; draw a part "
                    "of the wall");
        }
        if (ends) return;
    }
}

} // namespace

dem::Point placed(const DxfContent& content, int line, dem::Point p)
{
    const PlaneTransform& t = content.within.transform;
    return checked_point(content.drawing.frame, line, t.a * p.x + t.c * p.z + t.e,
                         t.b * p.x + t.d * p.z + t.f);
}

void add_block(DxfContent& content, const DxfEntity& block, DxfGroups& groups)
{
    const DrawingFrame& frame = content.drawing.frame;
    const DxfGroup* name = find_group(block, 2);
    constexpr int kExternal = 4, kOverlaid = 8;
    DxfBlock b{name ? dxf_name(name->value) : "", groups.place(),
               point_of(frame, block, 10, 20),
               (integer_of(frame, block, 70, 0) & (kExternal | kOverlaid)) != 0};
    while (const std::optional<DxfGroup> group = groups.next()) {
        if (group->code != 0) continue;
        if (group->value == "ENDBLK") {
            std::string key = upper_case(b.name);
            content.blocks.defined.insert_or_assign(std::move(key), std::move(b));
            return;
        }
        if (group->value == "BLOCK" || group->value == "ENDSEC" || group->value == "EOF") break;
    }
    refuse(frame, block.line,
           "the block \"" + b.name + "\" has no end; save the drawing as DXF again");
}

void insert_block(DxfContent& content, const DxfEntity& insert, const std::string& layer,
                  DxfGroups& groups)
{
    DrawingFrame& frame = content.drawing.frame;
    const DxfGroup* named = find_group(insert, 2);
    if (!named) refuse(frame, insert.line, "INSERT names no block; delete it");
    const DxfBlock& block = block_of(content, insert, dxf_name(named->value));
    const PlaneTransform shape = shape_of(content, insert, block);
    const PlaneTransform place = place_of(frame, insert);
    const Grid grid = grid_of(frame, insert);

    ++content.blocks.inserted[block.name];
    const DxfGroups::Place back = groups.place();
    const DxfInsertion around = content.within;
    const std::string part = frame.part;
    if (around.line == 0) content.within.line = insert.line;
    content.within.layer = layer;
    content.within.names.push_back(upper_case(block.name));
    frame.part = " (in the block \"" + block.name + "\", which line " +
                 std::to_string(content.within.line) + " inserts)";
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            content.within.transform = around.transform * place *
                                       moved_by(column * grid.across, row * grid.up) * shape;
            add_content(content, block, insert, groups);
        }
    content.within = around;
    frame.part = part;
    groups.go_to(back);
}

void note_inserted(DxfContent& content)
{
    if (content.blocks.inserted.empty()) return;
    constexpr std::size_t kShown = 6;
    std::size_t all = 0, shown = 0;
    std::string names;
    for (const auto& [name, n] : content.blocks.inserted) {
        all += n;
        if (++shown > kShown) continue;
        names += (names.empty() ? "" : ", ") + std::to_string(n) + " " + name;
    }
    if (shown > kShown) names += ", and others";
    content.drawing.notes.push_back(
        counted(all, "insertion of a block was", "insertions of blocks were") +
        " expanded: " + names + ".");
    if (content.blocks.clipped == 0) return;
    const bool one = content.blocks.clipped == 1;
    content.drawing.notes.push_back(counted(content.blocks.clipped, "insertion of a block has",
                                            "insertions of blocks have") +
                                    " a clip boundary (XCLIP), which is not read: " +
                                    (one ? "its" : "their") + " whole outlines count.");
}

} // namespace app
