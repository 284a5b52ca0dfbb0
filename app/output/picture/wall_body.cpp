#include "app/output/picture/wall_body.hpp"

#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace app {

namespace {

using dem::ContactState;
using dem::FaceKind;
using dem::FaceState;
using dem::Point;
using dem::Snapshot;

constexpr std::array<const char*, 3> kStoneTints = {"#f3ecdf", "#ece3d2", "#f0e8d8"};

/// Where the compression of a face acts.
Pixel resultant(const Snapshot& wall, const WallView& view, const FaceState& face)
{
    Pixel at;
    for (const ContactState& c : face.contacts) {
        const double share = std::max(0.0, -c.sigma) * c.area / compression_of(face);
        const Pixel p = place_contact(wall, view, face, c).middle;
        at = {at.x + share * p.x, at.y + share * p.y};
    }
    return at;
}

Pixel centre(const dem::BlockState& block, const WallView& view)
{
    Pixel sum;
    for (std::size_t i = 0; i < block.outline.size(); ++i) {
        const Pixel p = view.place(block.outline[i], block.displacement.at(i));
        sum = {sum.x + p.x, sum.y + p.y};
    }
    const double n = static_cast<double>(block.outline.size());
    return {sum.x / n, sum.y / n};
}

bool on_line_of(const FaceState& face, Point p)
{
    if (face.contacts.empty()) return false;
    const Point q = face.contacts.front().at;
    constexpr double kSame = 1e-7; // [m]
    return std::abs((p.x - q.x) * face.normal.x + (p.z - q.z) * face.normal.z) < kSame;
}

/// The crack faces of each block: their edges are not drawn, so that two halves look like one
/// stone.
std::vector<std::vector<const FaceState*>> cracks_of_blocks(const Snapshot& wall)
{
    std::vector<std::vector<const FaceState*>> cracks(wall.blocks.size());
    for (const FaceState& face : wall.faces)
        if (face.kind == FaceKind::unit_crack)
            for (const int block : {face.block_a, face.block_b})
                if (block >= 0) cracks.at(block).push_back(&face);
    return cracks;
}

std::string draw_block_edges(const dem::BlockState& block, std::span<const Pixel> outline,
                             const std::vector<const FaceState*>& cracks)
{
    std::string result;
    std::vector<Pixel> run; // edges up to the next crack
    const auto flush = [&] {
        if (run.size() > 1)
            result +=
                svg_polyline(run, svg_stroke(block.course == 0 ? "#7d828a" : "#a3937a", 0.8));
        run.clear();
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        const bool hidden = std::ranges::any_of(cracks, [&](const FaceState* crack) {
            return on_line_of(*crack, block.outline[i]) &&
                   on_line_of(*crack, block.outline[next]);
        });
        if (hidden) {
            flush();
            continue;
        }
        if (run.empty()) run.push_back(outline[i]);
        run.push_back(outline[next]);
    }
    flush();
    return result;
}

} // namespace

std::string draw_undeformed(const Snapshot& wall, const WallView& view)
{
    std::string blocks;
    for (const dem::BlockState& block : wall.blocks) {
        std::vector<Pixel> outline;
        for (const Point& p : block.outline) outline.push_back(view.place(p));
        blocks += svg_polygon(outline, "");
    }
    return svg_group(svg_stroke("#d4d4d4", 0.7), blocks);
}

StoneTints stone_tints(const dem::Layout& layout)
{
    StoneTints tints;
    bool lintels = false, others = false;
    for (const dem::Block& block : layout.blocks) {
        if (block.unit < 1 || block.material == 0) continue;
        tints.kind.resize(std::max(tints.kind.size(), static_cast<std::size_t>(block.unit)));
        tints.kind[static_cast<std::size_t>(block.unit) - 1] = block.material;
        (block.material == layout.lintels ? lintels : others) = true;
    }
    if (others)
        tints.name = "units of other stone";
    else if (lintels)
        tints.name = "lintels";
    return tints;
}

const char* block_tint(const dem::BlockState& block, const StoneTints& tints)
{
    if (block.course == 0) return "#c9ccd1";
    const auto unit = static_cast<std::size_t>(block.unit);
    const int kind = unit >= 1 && unit <= tints.kind.size() ? tints.kind[unit - 1] : 0;
    if (kind == 0) return kStoneTints[unit % kStoneTints.size()];
    return kKindTints[static_cast<std::size_t>(kind) % kKindTints.size()];
}

std::string draw_blocks(const Snapshot& wall, const WallView& view, const StoneTints& tints)
{
    const auto cracks = cracks_of_blocks(wall);
    std::string stones, edges;
    for (std::size_t k = 0; k < wall.blocks.size(); ++k) {
        const dem::BlockState& block = wall.blocks[k];
        std::vector<Pixel> outline;
        for (std::size_t i = 0; i < block.outline.size(); ++i)
            outline.push_back(view.place(block.outline[i], block.displacement.at(i)));
        const std::string colour = block_tint(block, tints);
        // a stroke of its own colour closes the hairline between two halves
        stones += svg_polygon(outline,
                              svg_attribute("fill", colour) + svg_attribute("stroke", colour));
        edges += draw_block_edges(block, outline, cracks[k]);
    }
    return svg_group("stroke-width=\"0.8\" stroke-linejoin=\"round\"", stones) + edges;
}

std::string draw_thrust(const Snapshot& wall, const WallView& view, double widest_force)
{
    if (!(widest_force > 0.0)) return {};
    std::string struts;
    for (const FaceState& face : wall.faces) {
        const double share = compression_of(face) / widest_force;
        if (share < 0.02) continue; // thinner than a hairline
        const Pixel at = resultant(wall, view, face);
        const double width = view.mark_size * kThrustWidest * share;
        for (const int index : {face.block_a, face.block_b}) {
            if (index < 0) continue;
            const dem::BlockState& block = wall.blocks.at(index);
            Pixel end = centre(block, view);
            if (block.course == 0)
                end = {at.x, at.y + (end.y - at.y) * 0.6}; // straight up into the beam
            struts += svg_line(at, end, svg_attribute("stroke-width", svg_number(width)));
        }
    }
    // one opacity for all, so that crossings are not darker
    return svg_group(svg_attribute("stroke", kThrustColour) +
                         "opacity=\"0.6\" stroke-linecap=\"round\"",
                     struts);
}

} // namespace app
