#include "app/drawing/outlines/drawing_formats.hpp"

#include "app/drawing/json_keys.hpp"
#include "app/drawing/outlines/drawing_file.hpp"
#include "app/drawing/outlines/space_mesh.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace app {
namespace {

using nlohmann::json;

constexpr int kDeepest = 64; // levels; COMPAS writes about 10

/// Reads characters and counts the lines, because the parser keeps no places.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    int* line = nullptr;

    const char& operator*() const { return *at; }
    CountingIterator& operator++()
    {
        if (*at == '\n') ++*line;
        ++at;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return at == other.at; }
    bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

/// An array or object that is being read.
struct Begun {
    int line = 0;
    std::size_t taken = 0; ///< outlines and meshes before it
    bool list = false;     ///< an array
    DifferentKeys keys;    ///< of an object, so far
};

struct JsonContent {
    RawDrawing drawing;
    double snap = 0.0;
    int line = 1;             ///< being read
    std::vector<Begun> begun; ///< the array or object of each level
    std::string key;          ///< the last of the outermost object
    std::vector<SpaceMesh> meshes;
    bool has_blocks = false; ///< the outermost object lists "blocks"
    UnknownKeys unknown_keys;

    [[nodiscard]] std::size_t taken() const { return drawing.outlines.size() + meshes.size(); }
};

/// The outline [[x, y], ...] as JSON.
RawOutline outline_of(const DrawingFrame& frame, const json& corners, int line)
{
    RawOutline outline{{}, "", line};
    for (const json& corner : corners) {
        if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() ||
            !corner[1].is_number()) {
            refuse(frame, line,
                   "a corner is not [x, y], two numbers; write the outline as [[x, y], [x, y], "
                   "...], y upwards");
        }
        outline.corners.push_back(
            checked_point(frame, line, corner[0].get<double>(), corner[1].get<double>()));
    }
    return outline;
}

bool is_mesh(const json& object)
{
    return (object.contains("vertex") && object.contains("face") &&
            object["vertex"].is_object() && object["face"].is_object()) ||
           (object.contains("vertices") && object.contains("faces") &&
            object["vertices"].is_array() && object["faces"].is_array());
}

std::array<double, 3> space_point(const DrawingFrame& frame, const json& point, int line)
{
    std::array<double, 3> p{};
    constexpr std::array kNames = {"x", "y",
                                   "z"}; // COMPAS leaves out what equals its default, 0
    for (std::size_t i = 0; i < 3; ++i) {
        const json* value = nullptr;
        if (point.is_object() && point.contains(kNames[i])) value = &point[kNames[i]];
        if (point.is_array() && i < point.size()) value = &point[i];
        if (value && !value->is_number())
            refuse(frame, line, "a vertex of a mesh has a coordinate that is not a number");
        if (value) p[i] = value->get<double>();
        p[i] = checked_point(frame, line, p[i], 0.0).x;
    }
    return p;
}

/// A vertex as faces name it: a number, or its text.
std::string vertex_name(const DrawingFrame& frame, const json& name, int line)
{
    if (name.is_string()) return name.get<std::string>();
    if (!name.is_number_integer())
        refuse(frame, line, "a face of a mesh is not a list of vertices");
    return name.is_number_unsigned() ? std::to_string(name.get<std::uint64_t>())
                                     : std::to_string(name.get<std::int64_t>());
}

std::string layer_of(const json& object)
{
    const auto layer = object.find("layer");
    return layer != object.end() && layer->is_string()
               ? readable_name(layer->get<std::string>())
               : "";
}

/// In the dictionaries of COMPAS, or in lists.
SpaceMesh mesh_of(const DrawingFrame& frame, const json& object, int line)
{
    const bool lists = object.contains("vertices");
    const json& vertices = object[lists ? "vertices" : "vertex"];
    SpaceMesh mesh;
    mesh.layer = layer_of(object);
    mesh.line = line;
    std::map<std::string, int> index;
    for (auto it = vertices.begin(); it != vertices.end(); ++it) {
        const int i = static_cast<int>(mesh.points.size());
        index[lists ? std::to_string(i) : it.key()] = i;
        mesh.points.push_back(space_point(frame, *it, line));
    }
    for (const json& face : object[lists ? "faces" : "face"]) {
        if (!face.is_array()) refuse(frame, line, "a face of a mesh is not a list of vertices");
        std::vector<int> corners;
        for (const json& name : face) {
            const auto found = index.find(vertex_name(frame, name, line));
            if (found == index.end())
                refuse(frame, line, "a face of a mesh names a vertex that is not there");
            corners.push_back(found->second);
        }
        if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        mesh.faces.push_back(std::move(corners));
    }
    if (mesh.points.empty() || mesh.faces.empty())
        refuse(frame, line, "a mesh has no faces; delete it");
    return mesh;
}

/// A polygon of COMPAS is a mesh of one face.
bool is_polygon(const json& object)
{
    const auto type = object.find("dtype");
    const auto data = object.find("data");
    return type != object.end() && type->is_string() &&
           type->get<std::string>().ends_with("/Polygon") && data != object.end() &&
           data->is_object() && data->contains("points") && (*data)["points"].is_array();
}

/// True if it was something.
bool add_object(JsonContent& content, const json& object, int line)
{
    RawDrawing& drawing = content.drawing;
    if (object.contains("outline")) {
        if (!object["outline"].is_array()) {
            refuse(drawing.frame, line,
                   "\"outline\" is not a list; write [[x, y], [x, y], ...]");
        }
        RawOutline outline = outline_of(drawing.frame, object["outline"], line);
        outline.layer = layer_of(object);
        if (object.contains("layer") && !object["layer"].is_string())
            refuse(drawing.frame, line, "\"layer\" is not text; write its name in quotes");
        content.unknown_keys.count(object, {"outline", "layer"});
        add_outline(drawing, std::move(outline), true, content.snap);
    } else if (is_mesh(object)) {
        content.meshes.push_back(mesh_of(drawing.frame, object, line));
    } else if (is_polygon(object)) {
        SpaceMesh polygon;
        polygon.line = line;
        for (const json& point : object["data"]["points"]) {
            polygon.points.push_back(space_point(drawing.frame, point, line));
        }
        if (polygon.points.size() < 3)
            refuse(drawing.frame, line, "a polygon has fewer than three points; delete it");
        std::vector<int>& face = polygon.faces.emplace_back();
        for (std::size_t i = 0; i < polygon.points.size(); ++i)
            face.push_back(static_cast<int>(i));
        content.meshes.push_back(std::move(polygon));
    } else {
        return false;
    }
    return true;
}

/// Each object in a list of blocks must be a block, or have one within.
void refuse_no_block(const JsonContent& content, const json& object, const Begun& begun)
{
    if (content.taken() > begun.taken) return;
    refuse(content.drawing.frame, begun.line,
           "an object of \"blocks\" has no \"outline\" (it has: " + keys_of(object) +
               "); write {\"outline\": [[x, y], [x, y], ...], \"layer\": \"name\"}");
}

/// Called by the parser whenever something begins or ends. Objects are taken when they end, and
/// then forgotten.
bool take(JsonContent& content, int depth, json::parse_event_t event, json& parsed)
{
    const auto level = static_cast<std::size_t>(depth);
    switch (event) {
    case json::parse_event_t::key:
        content.begun[level - 1].keys.add(parsed.get<std::string>(), content.drawing.frame,
                                          content.line, content.begun[level - 1].line);
        if (depth == 1) content.key = parsed.get<std::string>();
        break;
    case json::parse_event_t::object_start:
    case json::parse_event_t::array_start:
        if (depth > kDeepest) {
            refuse(content.drawing.frame, content.line,
                   "lists are nested more than 64 deep; no drawing needs that");
        }
        content.begun.resize(level);
        content.begun.push_back(
            {content.line, content.taken(), event == json::parse_event_t::array_start, {}});
        break;
    case json::parse_event_t::object_end:
        if (add_object(content, parsed, content.begun[level].line)) return false;
        if (depth == 2 && content.key == "blocks" && content.begun[1].list)
            refuse_no_block(content, parsed, content.begun[level]);
        if (depth == 0 && content.has_blocks) content.unknown_keys.count(parsed, {"blocks"});
        break;
    case json::parse_event_t::array_end:
        content.has_blocks |= depth == 1 && content.key == "blocks";
        if (depth == 2 && content.key == "blocks") {
            add_outline(content.drawing,
                        outline_of(content.drawing.frame, parsed, content.begun[level].line),
                        true, content.snap);
        }
        break;
    case json::parse_event_t::value:
        if (depth == 2 && content.key == "blocks" && content.begun[1].list)
            refuse(content.drawing.frame, content.line,
                   "\"blocks\" has something that is neither a list of corners nor an object; "
                   "delete it");
        break;
    default:
        break;
    }
    return true;
}

} // namespace

RawDrawing read_json_drawing(const DrawingFrame& frame, std::string_view bytes, double snap)
{
    JsonContent content;
    content.drawing.frame = frame;
    content.snap = snap;
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3); // byte order mark
    const CountingIterator begin{bytes.data(), &content.line},
        end{bytes.data() + bytes.size(), &content.line};
    try {
        const json::parser_callback_t callback = [&](int depth, json::parse_event_t event,
                                                     json& parsed) {
            return take(content, depth, event, parsed);
        };
        const json whole = json::parse(begin, end, callback);
        static_cast<void>(whole);
    } catch (const json::exception& e) {
        std::string_view why =
            e.what(); // "[json.exception.parse_error.101] parse error at line 1, column 5: ..."
        const std::size_t from = why.rfind(": ");
        if (from != std::string_view::npos) why.remove_prefix(from + 2);
        refuse(frame, content.line,
               "is not JSON (" + readable_name(why.substr(0, 200)) +
                   "); export the drawing again");
    }
    content.unknown_keys.note(content.drawing);
    add_meshes(content.drawing, content.meshes, snap);
    if (content.drawing.outlines.empty()) {
        refuse(frame, 0,
               "holds no blocks; write {\"blocks\": [[[x, y], [x, y], ...], ...]}, or a mesh "
               "as COMPAS does");
    }
    return std::move(content.drawing);
}

} // namespace app
