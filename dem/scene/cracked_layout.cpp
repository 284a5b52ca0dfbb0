#include "dem/scene/cracked_layout.hpp"

#include "dem/scene/geometry/clip.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace dem {

namespace {

/// The blocks of a scene in place of those of another, and where each comes from.
struct Pieces {
    std::vector<Block> blocks;
    std::vector<int> whole; ///< index of the block that each was
};

/// A piece keeps the support of its block where it has that part of it.
Motion support_of(const Block& whole, const Block& piece)
{
    const bool left = is_held_left(whole.motion);
    const bool side = left ? std::abs(piece.x0 - whole.x0) < kTouching
                           : std::abs(piece.x1 - whole.x1) < kTouching,
               floor = !level_sides(piece, whole.z0, false).empty();
    const Motion hinge = left ? Motion::held_left_corner : Motion::held_right_corner;
    switch (whole.motion) {
    case Motion::clamped_bottom:
        return floor ? Motion::clamped_bottom : Motion::free;
    case Motion::clamped_bottom_held_right:
    case Motion::clamped_bottom_held_left:
        if (floor) return side ? whole.motion : Motion::clamped_bottom;
        return side && has_lower_corner(piece, left) ? hinge : Motion::free;
    case Motion::held_right_corner:
    case Motion::held_left_corner:
        return floor && side ? hinge : Motion::free;
    default:
        return whole.motion;
    }
}

Pieces divide(const Layout& scene, const UnitCracks& cracks, double unit_length)
{
    std::map<int, int> blocks_of_unit;
    for (const Block& b : scene.blocks) ++blocks_of_unit[b.unit];
    Pieces all;
    for (int i = 0; i < static_cast<int>(scene.blocks.size()); ++i) {
        const Block& whole = scene.blocks[i];
        const CrackPattern& pattern = pattern_at(cracks, centre_of(whole));
        std::vector<Outline> outlines;
        const bool lintel = whole.material != 0 && whole.material == scene.lintels;
        if (i != scene.beam && !lintel && blocks_of_unit[whole.unit] == 1)
            outlines = pieces_of(corners_of(whole), pattern, unit_length,
                                 cracks.seed + static_cast<unsigned>(whole.unit));
        if (outlines.size() < 2) {
            all.blocks.push_back(whole);
            all.whole.push_back(i);
            continue;
        }
        for (Outline& outline : outlines) {
            Block piece = block_of(std::move(outline));
            piece.course = whole.course;
            piece.unit = whole.unit;
            piece.material = whole.material;
            piece.layer = whole.layer;
            piece.motion = support_of(whole, piece);
            piece.between_cracks = shares_stiffness(pattern);
            all.blocks.push_back(std::move(piece));
            all.whole.push_back(i);
        }
    }
    return all;
}

/// The face of the scene that a touch of two pieces is part of; -1: none.
int face_with(const Touch& t, const std::vector<int>& candidates, const Layout& scene)
{
    const Point middle{0.5 * (t.from.x + t.to.x), 0.5 * (t.from.z + t.to.z)};
    for (const int f : candidates) {
        const Face& face = scene.faces[f];
        const double along = face.normal.x * t.normal.x + face.normal.z * t.normal.z;
        if (along > 0.999 && distance_to_segment(middle, face.from, face.to) < 10.0 * kTouching)
            return f;
    }
    return -1;
}

/// A part of a face, and its place in the list.
struct Part {
    int face;     ///< of the scene; cracks come last
    double place; ///< along the face [m]
    Face part;
};

void add_base_parts(const Layout& scene, const Pieces& pieces, std::vector<Part>& parts)
{
    for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
        const Face& face = scene.faces[f];
        if (face.a != kGround) continue;
        for (int b = 0; b < static_cast<int>(pieces.blocks.size()); ++b) {
            if (pieces.whole[b] != face.b) continue;
            for (const auto& [x0, x1] : level_sides(pieces.blocks[b], face.from.z, false)) {
                Face part = face;
                part.b = b;
                part.from.x = std::max(x0, face.from.x);
                part.to.x = std::min(x1, face.to.x);
                if (part.to.x - part.from.x >= kShortestFace)
                    parts.push_back({f, part.from.x, part});
            }
        }
    }
}

std::vector<Part> parts_of(const Layout& scene, const Pieces& pieces)
{
    std::map<std::pair<int, int>, std::vector<int>> faces_between;
    for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f)
        faces_between[{scene.faces[f].a, scene.faces[f].b}].push_back(f);
    std::vector<Part> parts;
    add_base_parts(scene, pieces, parts);
    for (const Touch& t : touching(pieces.blocks)) {
        const int a = pieces.whole[t.a], b = pieces.whole[t.b];
        Face part{FaceKind::unit_crack, 0, t.a, t.b, t.from, t.to, t.normal};
        int face = std::numeric_limits<int>::max();
        if (a != b) {
            face = face_with(t, faces_between[{a, b}], scene);
            if (face < 0) continue; // a corner that meets a side
            part.kind = scene.faces[face].kind;
            part.id = scene.faces[face].id;
        }
        const Point along{t.normal.z, -t.normal.x};
        parts.push_back(
            {face, a == b ? t.a : std::abs(t.from.x * along.x + t.from.z * along.z), part});
    }
    std::ranges::stable_sort(parts, [](const Part& p, const Part& q) {
        return std::pair(p.face, p.place) < std::pair(q.face, q.place);
    });
    return parts;
}

/// Distance of the middles of two pieces across their crack [m].
double spacing_of(const Face& crack, const std::vector<Block>& blocks)
{
    const Point a = centre_of(blocks[crack.a]), b = centre_of(blocks[crack.b]);
    return std::abs((b.x - a.x) * crack.normal.x + (b.z - a.z) * crack.normal.z);
}

} // namespace

Layout with_cracks(Layout scene, const UnitCracks& cracks, double unit_length)
{
    Pieces pieces = divide(scene, cracks, unit_length);
    if (pieces.blocks.size() == scene.blocks.size()) return scene;
    const std::vector<Part> parts = parts_of(scene, pieces);
    scene.crack_stiffness.assign(static_cast<std::size_t>(scene.n_cracks), 0.0);
    scene.faces.clear();
    for (const Part& p : parts) {
        Face f = p.part;
        if (f.kind == FaceKind::unit_crack && f.id == 0) {
            f.id = ++scene.n_cracks;
            const bool shares = pieces.blocks[f.a].between_cracks;
            scene.crack_stiffness.push_back(
                shares ? cracks.rigidity / spacing_of(f, pieces.blocks) : 0.0);
        }
        scene.faces.push_back(f);
    }
    scene.beam += static_cast<int>(pieces.blocks.size() - scene.blocks.size());
    scene.blocks = std::move(pieces.blocks);
    scene.crack_rigidity = cracks.rigidity;
    scene.divided = true;
    return scene;
}

} // namespace dem
