#include "app/drawing/outlines/drawing_formats.hpp"

#include "app/drawing/dxf_entities.hpp"
#include "app/drawing/dxf_groups.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace app {
namespace {

void refuse_other_formats(const DrawingFrame& frame, std::string_view bytes)
{
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        refuse(frame, 0, "is a binary DXF; save it as ASCII DXF");
    }
    if (bytes.starts_with("AC10")) {
        refuse(frame, 0, "is a DWG drawing; save it as ASCII DXF");
    }
    if (bytes.find('\0') != std::string_view::npos) {
        refuse(frame, 0, "holds bytes that are not text; save the drawing as ASCII DXF");
    }
}

/// Units besides kLengthUnits that a DXF may state.
constexpr std::array<LengthUnit, 10> kRareUnits = {{{"mi", 1609.344, 3},
                                                    {"km", 1e3, 7},
                                                    {"microinch", 25.4e-9, 8},
                                                    {"mil", 25.4e-6, 9},
                                                    {"yd", 0.9144, 10},
                                                    {"µm", 1e-6, 13},
                                                    {"dm", 0.1, 14},
                                                    {"dam", 10.0, 15},
                                                    {"hm", 100.0, 16},
                                                    {"US survey ft", 1200.0 / 3937.0, 21}}};

/// Unit of length for a code of the header variable $INSUNITS; without a name or length where
/// the code states none.
LengthUnit inserted_unit(int code)
{
    const auto usual = std::ranges::find(kLengthUnits, code, &LengthUnit::dxf_code);
    if (usual != kLengthUnits.end()) return *usual;
    const auto rare = std::ranges::find(kRareUnits, code, &LengthUnit::dxf_code);
    return rare != kRareUnits.end() ? *rare : LengthUnit{};
}

/// Reads to the end of the section HEADER.
void read_header(DxfContent& content, DxfGroups& groups)
{
    bool wanted = false;
    while (const std::optional<DxfGroup> group = groups.next()) {
        if (group->code == 0) break;
        if (group->code == 9) wanted = group->value == "$INSUNITS";
        if (group->code != 70 || !wanted) continue;
        const LengthUnit unit = inserted_unit(dxf_integer(content.drawing.frame, *group));
        state_unit(content.drawing, unit.metres, unit.name);
    }
}

/// Keeps an entry that what is drawn depends on, of the sections TABLES, BLOCKS and OBJECTS: a
/// layer that is off or frozen, a block, a clip boundary of an inserted block.
void read_entry(DxfContent& content, const DxfGroup& head, DxfGroups& groups)
{
    if (head.value == "LAYER") add_layer(content, read_entity(groups, head));
    if (head.value == "BLOCK") add_block(content, read_entity(groups, head), groups);
    if (head.value == "SPATIAL_FILTER") ++content.blocks.clipped;
}

/// Reads to the end of such a section.
void read_section(DxfContent& content, DxfGroups& groups)
{
    while (const std::optional<DxfGroup> head = groups.next()) {
        if (head->code != 0) continue;
        if (head->value == "ENDSEC") return;
        read_entry(content, *head, groups);
        if (head->value == "EOF" || head->value == "SECTION") {
            groups.step_back();
            return;
        }
    }
}

/// Reads to the end of the section ENTITIES.
void read_entities(DxfContent& content, DxfGroups& groups)
{
    while (const std::optional<DxfGroup> head = groups.next()) {
        if (head->code != 0) continue;
        if (head->value == "ENDSEC") return;
        if (head->value == "EOF" || head->value == "SECTION") {
            refuse(content.drawing.frame, head->line,
                   "the section ENTITIES has no end; save the drawing as DXF again");
        }
        const DxfEntity entity = read_entity(groups, *head);
        add_entity(content, entity, groups);
    }
}

} // namespace

RawDrawing read_dxf(const DrawingFrame& frame, std::string_view bytes, double snap)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"; // of UTF-8
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    refuse_other_formats(frame, bytes);
    DxfContent content;
    content.drawing.frame = frame;
    content.snap = snap;
    DxfGroups groups(content.drawing.frame, bytes);
    bool whole = false, has_entities = false, begins_section = false;
    while (const std::optional<DxfGroup> group = groups.next()) {
        if (group->code == 0) {
            whole = group->value == "EOF";
            if (whole) break;
            begins_section = group->value == "SECTION";
        } else if (group->code == 2 && begins_section) {
            begins_section = false;
            if (group->value == "HEADER") read_header(content, groups);
            if (group->value == "TABLES" || group->value == "BLOCKS" ||
                group->value == "OBJECTS")
                read_section(content, groups);
            if (group->value == "ENTITIES") {
                read_entities(content, groups);
                has_entities = true;
            }
        }
    }
    if (!whole)
        refuse(frame, groups.line(),
               "the file ends without EOF: it was cut off; save the drawing as DXF again");
    if (!has_entities)
        refuse(frame, groups.line(),
               "has no section ENTITIES; draw the outlines of the blocks in the model space");
    note_inserted(content);
    if (content.arcs > 0)
        content.drawing.notes.push_back(counted(content.arcs, "arc", "arcs") +
                                        " became straight pieces, at most " +
                                        millimetres(0.5 * snap) + " off (half of wall.snap).");
    note_ignored(content.drawing, content.ignored);
    if (content.in_paper_space > 0)
        content.drawing.notes.push_back(
            counted(content.in_paper_space, "entity", "entities") + " of the paper space " +
            (content.in_paper_space == 1 ? "was" : "were") + " ignored.");
    note_hidden(content.drawing, content.hidden);
    return std::move(content.drawing);
}

} // namespace app
