#include "app/drawing/outlines/line_faces.hpp"

#include "app/drawing/outlines/sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace app {
namespace {

/// One direction of a piece of line.
struct HalfLine {
    int from = 0, to = 0, line = 0; ///< nodes, index of RawDrawing::lines
    double angle = 0.0;             ///< [rad]
};

struct LineNetwork {
    std::vector<dem::Point> nodes;    ///< in the drawing's unit
    std::vector<HalfLine> half_lines; ///< sorted by node, then counter-clockwise
    std::vector<std::size_t> begin;   ///< of each node's half lines
};

/// The pieces between the nodes on each line, each once.
std::map<Side, int> pieces_of(const RawDrawing& drawing, const std::vector<dem::Point>& nodes,
                              const std::vector<Side>& lines, double snap)
{
    std::map<Side, int> pieces;
    const auto add = [&](int a, int b, std::size_t line) {
        if (a != b)
            pieces.emplace(Side{std::min(a, b), std::max(a, b)}, static_cast<int>(line));
    };
    const std::vector<std::vector<int>> between = nodes_on_sides(nodes, lines, snap);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        int last = lines[i].a;
        for (const int n : between[i]) {
            add(last, n, i);
            last = n;
        }
        add(last, lines[i].b, i);
    }
    std::vector<Side> sides;
    std::vector<int> owner;
    for (const auto& [side, line] : pieces) {
        sides.push_back(side);
        owner.push_back(line);
    }
    if (const std::optional<Crossing> crossing = first_crossing(nodes, sides)) {
        const auto line = [&](int side) { return drawing.lines[owner[side]].line; };
        refuse(drawing.frame, line(crossing->second),
               "this line crosses the one of line " + std::to_string(line(crossing->first)) +
                   " at " + raw_coordinates(drawing.frame, crossing->at) +
                   "; end both there, or, where they only overlap a little, make wall.snap (" +
                   millimetres(snap * drawing.frame.unit) + ") larger than that");
    }
    return pieces;
}

/// Where two lines cross, far from all four ends; nothing where they do not.
std::optional<dem::Point> crossing_of(const RawLine& one, const RawLine& other, double far)
{
    const dem::Point p = one.from, q = other.from, a{one.to.x - p.x, one.to.z - p.z},
                     b{other.to.x - q.x, other.to.z - q.z};
    const double turn = a.x * b.z - a.z * b.x;
    if (turn == 0.0) return {};
    const double along = ((q.x - p.x) * b.z - (q.z - p.z) * b.x) / turn,
                 across = ((q.x - p.x) * a.z - (q.z - p.z) * a.x) / turn;
    if (!(along > 0.0 && along < 1.0 && across > 0.0 && across < 1.0)) return {};
    const dem::Point at{p.x + along * a.x, p.z + along * a.z};
    for (const dem::Point end : {one.from, one.to, other.from, other.to})
        if (distance(at, end) <= far) return {};
    return at;
}

/// Lines drawn through others, as the joints of a stack bond, are cut where they cross. A
/// crossing near an end is a slip of the hand and stays.
void cut_crossing_lines(RawDrawing& drawing, double snap)
{
    constexpr double kFar = 20.0;        // times snap: a free choice, less than a stone
    constexpr std::size_t kMost = 5'000; // lines, of which each is compared with each
    const std::vector<RawLine> lines = drawing.lines;
    if (lines.size() > kMost) return;
    drawing.lines.clear();
    std::size_t crossings = 0;
    for (const RawLine& line : lines) {
        std::vector<dem::Point> cuts{line.from, line.to};
        for (const RawLine& other : lines)
            if (const auto at = crossing_of(line, other, kFar * snap)) cuts.push_back(*at);
        crossings += cuts.size() - 2;
        std::ranges::sort(cuts, {}, [&](dem::Point p) { return distance(p, line.from); });
        for (std::size_t i = 1; i < cuts.size(); ++i)
            add_line(drawing, {cuts[i - 1], cuts[i], line.layer, line.line});
    }
    if (crossings > 0)
        drawing.notes.push_back(counted(crossings / 2, "crossing", "crossings") +
                                " of two lines: both were cut there.");
}

LineNetwork connected(const RawDrawing& drawing, double snap)
{
    LineNetwork network;
    for (const RawLine& line : drawing.lines) {
        network.nodes.push_back(line.from);
        network.nodes.push_back(line.to);
    }
    const Welded welded = weld(network.nodes, snap);
    std::vector<Side> lines;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i)
        lines.push_back({welded.node[2 * i], welded.node[2 * i + 1]});
    for (const auto& [side, line] : pieces_of(drawing, network.nodes, lines, snap)) {
        const dem::Point a = network.nodes[side.a], b = network.nodes[side.b];
        network.half_lines.push_back({side.a, side.b, line, std::atan2(b.z - a.z, b.x - a.x)});
        network.half_lines.push_back({side.b, side.a, line, std::atan2(a.z - b.z, a.x - b.x)});
    }
    std::ranges::sort(network.half_lines, [](const HalfLine& a, const HalfLine& b) {
        return std::tuple(a.from, a.angle, a.to) < std::tuple(b.from, b.angle, b.to);
    });
    network.begin.assign(network.nodes.size() + 1, 0);
    for (const HalfLine& h : network.half_lines) ++network.begin[h.from + 1];
    for (std::size_t n = 0; n < network.nodes.size(); ++n)
        network.begin[n + 1] += network.begin[n];
    return network;
}

void refuse_loose_ends(const RawDrawing& drawing, const LineNetwork& network, double snap)
{
    for (std::size_t n = 0; n < network.nodes.size(); ++n) {
        if (network.begin[n + 1] - network.begin[n] != 1) continue;
        const int line = network.half_lines[network.begin[n]].line;
        refuse(drawing.frame, drawing.lines[line].line,
               "this line ends at " + raw_coordinates(drawing.frame, network.nodes[n]) +
                   ", where within wall.snap (" + millimetres(snap * drawing.frame.unit) +
                   ") no other begins; close the outline, or delete the line");
    }
}

/// The half line that follows around the face on the left of each.
std::vector<std::size_t> next_around(const LineNetwork& network)
{
    std::map<Side, std::size_t> index;
    for (std::size_t i = 0; i < network.half_lines.size(); ++i) {
        index[{network.half_lines[i].from, network.half_lines[i].to}] = i;
    }
    std::vector<std::size_t> next;
    for (const HalfLine& h : network.half_lines) {
        const std::size_t back = index[{h.to, h.from}], first = network.begin[h.to];
        const std::size_t last = network.begin[h.to + 1] - 1;
        next.push_back(back == first ? last : back - 1); // the next one clockwise
    }
    return next;
}

/// The layer that most of the length is on; of equal ones that of the first line.
std::string main_layer(const RawDrawing& drawing, const LineNetwork& network,
                       const std::vector<std::size_t>& face)
{
    std::map<std::string, double> lengths;
    for (const std::size_t i : face) {
        const HalfLine& h = network.half_lines[i];
        lengths[drawing.lines[h.line].layer] +=
            distance(network.nodes[h.from], network.nodes[h.to]);
    }
    const auto longest = std::ranges::max_element(lengths, [](const auto& a, const auto& b) {
        return a.second < b.second * (1.0 - 1e-9);
    });
    return longest->first;
}

/// Numbers of the areas that the lines enclose: each is a block or a gap.
struct Enclosed {
    std::size_t blocks = 0, gaps = 0;
};

/// Where each block has lines of its own, a little apart, the lines enclose slivers too.
/// @param snap in the drawing's unit
void add_face(RawDrawing& drawing, const LineNetwork& network,
              const std::vector<std::size_t>& face, double snap, Enclosed& enclosed)
{
    constexpr double kWidestGap = 2.0; // times snap: corners may be off by snap on either side
    RawOutline outline;
    double twice = 0.0, length = 0.0;
    for (const std::size_t i : face) {
        const HalfLine& h = network.half_lines[i];
        const dem::Point o = network.nodes[network.half_lines[face.front()].from];
        const dem::Point a = network.nodes[h.from], b = network.nodes[h.to];
        twice += (a.x - o.x) * (b.z - o.z) - (a.z - o.z) * (b.x - o.x);
        length += distance(a, b);
        outline.corners.push_back(a);
        const int line = drawing.lines[h.line].line;
        outline.line = outline.line == 0 ? line : std::min(outline.line, line);
    }
    if (twice <= 0.0) return;                  // what is around everything
    if (twice <= kWidestGap * snap * length) { // of a strip: width times its two long sides
        ++enclosed.gaps;
        return;
    }
    ++enclosed.blocks;
    outline.layer = main_layer(drawing, network, face);
    add_outline(drawing, std::move(outline), true, 0.0);
}

Enclosed add_faces(RawDrawing& drawing, const LineNetwork& network, double snap)
{
    const std::vector<std::size_t> next = next_around(network);
    const std::size_t none = network.half_lines.size();
    std::vector<std::size_t> face_of(none, none);
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t first = 0; first < none; ++first) {
        if (face_of[first] != none) continue;
        std::vector<std::size_t>& face = faces.emplace_back();
        for (std::size_t i = first; face_of[i] == none; i = next[i]) {
            face_of[i] = faces.size() - 1;
            face.push_back(i);
        }
    }
    std::map<Side, std::size_t> left; // the face on the left of each half line
    for (std::size_t i = 0; i < none; ++i)
        left[{network.half_lines[i].from, network.half_lines[i].to}] = face_of[i];
    for (std::size_t i = 0; i < none; ++i) {
        const HalfLine& h = network.half_lines[i];
        if (left[{h.to, h.from}] != face_of[i]) continue;
        refuse(drawing.frame, drawing.lines[h.line].line,
               "the line from " + raw_coordinates(drawing.frame, network.nodes[h.from]) +
                   " to " + raw_coordinates(drawing.frame, network.nodes[h.to]) +
                   " is not a side of a closed outline; delete it");
    }
    Enclosed enclosed;
    for (const std::vector<std::size_t>& face : faces)
        add_face(drawing, network, face, snap, enclosed);
    return enclosed;
}

} // namespace

void add_line_faces(RawDrawing& drawing, double snap)
{
    if (drawing.lines.empty()) return;
    Enclosed enclosed;
    const double tolerance = snap / drawing.frame.unit;
    cut_crossing_lines(drawing, tolerance);
    try {
        const LineNetwork network = connected(drawing, tolerance);
        refuse_loose_ends(drawing, network, tolerance);
        enclosed = add_faces(drawing, network, tolerance);
    } catch (const TooCrowded& crowd) {
        refuse(drawing.frame, 0,
               "has too many lines near " + raw_coordinates(drawing.frame, crowd.at) +
                   "; simplify the drawing there");
    }
    drawing.notes.push_back(counted(drawing.lines.size(), "line encloses ", "lines enclose ") +
                            counted(enclosed.blocks, "block", "blocks") +
                            "; each enclosed area is a block, even an opening.");
    if (enclosed.gaps > 0)
        drawing.notes.push_back(
            counted(enclosed.gaps, "area", "areas") + " between lines, at most " +
            millimetres(2.0 * snap) + " wide, " +
            (enclosed.gaps == 1 ? "was taken as a gap" : "were taken as gaps") +
            " between blocks; a larger wall.snap would join the lines.");
}

} // namespace app
