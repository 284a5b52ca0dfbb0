#include "app/drawing/dxf_drawing.hpp"

#include "app/drawing/dxf_entities.hpp"
#include "app/drawing/dxf_groups.hpp"

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
        refuse(frame, 0, "holds bytes that are no text; save the drawing as ASCII DXF");
    }
}

struct NamedUnit {
    std::string_view name;
    double length; ///< [m]; 0: none stated
};

/// Of the header variable $INSUNITS (DXF reference of Autodesk, HEADER section).
NamedUnit inserted_unit(int code)
{
    switch (code) {
    case 1:
        return {"in", 0.0254};
    case 2:
        return {"ft", 0.3048};
    case 3:
        return {"mi", 1609.344};
    case 4:
        return {"mm", 1e-3};
    case 5:
        return {"cm", 1e-2};
    case 6:
        return {"m", 1.0};
    case 7:
        return {"km", 1e3};
    case 8:
        return {"microinch", 25.4e-9};
    case 9:
        return {"mil", 25.4e-6};
    case 10:
        return {"yd", 0.9144};
    case 13:
        return {"µm", 1e-6};
    case 14:
        return {"dm", 0.1};
    case 15:
        return {"dam", 10.0};
    case 16:
        return {"hm", 100.0};
    case 21:
        return {"US survey ft", 1200.0 / 3937.0};
    default:
        return {"", 0.0};
    }
}

/// Reads to the end of the section HEADER.
void read_header(DxfContent& content, DxfGroups& groups)
{
    bool wanted = false;
    DxfGroup group;
    while (groups.next(group)) {
        if (group.code == 0) break;
        if (group.code == 9) wanted = group.value == "$INSUNITS";
        if (group.code != 70 || !wanted) continue;
        const NamedUnit unit = inserted_unit(dxf_integer(content.drawing.frame, group));
        state_unit(content.drawing, unit.length, unit.name);
    }
}

/// Reads to the end of the section TABLES, for the layers that are off or frozen.
void read_tables(DxfContent& content, DxfGroups& groups)
{
    DxfGroup head;
    while (groups.next(head)) {
        if (head.code != 0) continue;
        if (head.value == "ENDSEC") return;
        if (head.value == "LAYER") add_layer(content, read_entity(groups, head));
        if (head.value == "EOF" || head.value == "SECTION") {
            groups.step_back();
            return;
        }
    }
}

/// Reads to the end of the section ENTITIES.
void read_entities(DxfContent& content, DxfGroups& groups)
{
    DxfGroup head;
    while (groups.next(head)) {
        if (head.code != 0) continue;
        if (head.value == "ENDSEC") return;
        if (head.value == "EOF" || head.value == "SECTION") {
            refuse(content.drawing.frame, head.line,
                   "the section ENTITIES has no end; save the drawing as DXF again");
        }
        const DxfEntity entity = read_entity(groups, head);
        add_entity(content, entity, groups);
    }
}

void note_what_was_ignored(DxfContent& content)
{
    std::string list;
    for (const auto& [type, n] : content.ignored) {
        list += (list.empty() ? "" : ", ") + std::to_string(n) + " " + type;
    }
    if (!list.empty())
        content.drawing.notes.push_back("Ignored, because they are no outlines: " + list + ".");
    if (content.in_paper_space == 0) return;
    content.drawing.notes.push_back(counted(content.in_paper_space, "entity", "entities") +
                                    " of the paper space ignored.");
}

} // namespace

RawDrawing read_dxf(const DrawingFrame& frame, std::string_view bytes, double snap)
{
    refuse_other_formats(frame, bytes);
    DxfContent content;
    content.drawing.frame = frame;
    content.snap = snap;
    DxfGroups groups(content.drawing.frame, bytes);
    DxfGroup group;
    bool whole = false, has_entities = false, begins_section = false;
    while (groups.next(group)) {
        if (group.code == 0) {
            whole = group.value == "EOF";
            if (whole) break;
            begins_section = group.value == "SECTION";
        } else if (group.code == 2 && begins_section) {
            begins_section = false;
            if (group.value == "HEADER") read_header(content, groups);
            if (group.value == "TABLES") read_tables(content, groups);
            if (group.value == "ENTITIES") {
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
    note_what_was_ignored(content);
    note_hidden(content.drawing, content.hidden);
    return std::move(content.drawing);
}

} // namespace app
