#include "dem/solver/state/finite_tables.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/touching.hpp"
#include "dem/solver/state/step_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dem {

namespace {

/// Share of the thickness of the thinner block across a joint to which it may be pressed
/// together. A free choice; docs/model.md, *Joints that close far*, has its effect.
constexpr double kDeepest = 0.5;
/// Share of a face, or of half a unit where that is longer, by which sides that come to overlap
/// from beside may lie within each other.
constexpr double kShallow = 0.05;

constexpr double kFar = 1e3; // [m], half the length of the ground
constexpr double kOnLine =
    1e-5; // [m], over blocks that follow each other with corners within kTouching
constexpr double kParallel = 1.0 - 1e-6; // cosine between the normals of sides on one line
constexpr std::size_t kReach = 3;        // blocks onto which a block can slide, to either side
constexpr double kUpward = 0.5;          // of the normal of a side that carries a block

FiniteTables::BlockRow block_row(const Model& m, int block)
{
    const Block& b = m.layout.blocks[block];
    const BlockElement& e = m.elements[m.places[block].element];
    FiniteTables::BlockRow row;
    row.rigid = static_cast<int>(e.rigid.cols());
    for (int i = 0; i < row.rigid; ++i)
        for (int d = 0; d < 3; ++d) row.motion[d][i] = e.rigid(d, i);
    row.turns_axes = row.rigid == 3;
    row.x = b.x0 + e.pivot.x;
    row.z = b.z0 + e.pivot.z;
    const Point centre = centre_of(b);
    row.centre_x = centre.x - row.x;
    row.centre_z = centre.z - row.z;
    row.volume = area_of(b) * m.layout.thickness;
    return row;
}

/// The operator of an element without its first modes.
ContactOperator without(int modes, const ContactOperator& all)
{
    ContactOperator a;
    a.ports = all.ports;
    a.modes = all.modes - modes;
    const int rows = 2 * all.ports;
    for (int r = 0; r < rows; ++r)
        for (int i = modes; i < all.modes; ++i)
            a.to_modes.push_back(all.to_modes[static_cast<std::size_t>(r) * all.modes + i]);
    a.to_contacts.assign(all.to_contacts.begin() + static_cast<std::ptrdiff_t>(modes) * rows,
                         all.to_contacts.end());
    return a;
}

/// The corners of the straight part of an outline that a face lies on.
std::vector<Point> corners_of_side(const Block& b, const Contact& c, const Face& f)
{
    if (b.outline.empty()) return {{b.x0, b.z0}, {b.x0, b.z1}, {b.x1, b.z0}, {b.x1, b.z1}};
    const std::size_t n = b.outline.size();
    const auto off = [&](Point p) {
        return std::abs(c.nx * (p.x - f.from.x) + c.nz * (p.z - f.from.z));
    };
    const auto along = [&](Point p) { return c.nz * p.x - c.nx * p.z; };
    const auto on_line = [&](std::size_t i) { return off(b.outline[i % n]) < kOnLine; };
    const double middle = 0.5 * (along(f.from) + along(f.to));
    for (std::size_t i = 0; i < n; ++i) {
        const double s0 = along(b.outline[i]), s1 = along(b.outline[(i + 1) % n]);
        if (!on_line(i) || !on_line(i + 1) || (s0 - middle) * (s1 - middle) > 0.0) continue;
        std::size_t first = i + n, last = i + n + 1;
        while (on_line(first - 1)) --first;
        while (on_line(last + 1)) ++last;
        return {b.outline[first % n], b.outline[last % n]};
    }
    return {f.from, f.to};
}

/// The side of a block that a face lies on.
Side side_of(const Model& m, const FiniteTables& t, int block, const Contact& c, const Face& f)
{
    const double tx = c.nz, tz = -c.nx;
    if (block == kGround) return {-kFar, kFar, c.nx * f.from.x + c.nz * f.from.z};
    const FiniteTables::BlockRow& row = t.blocks[block];
    const Block& b = m.layout.blocks[block];
    Side s{kFar, -kFar, c.nx * (f.from.x - row.x) + c.nz * (f.from.z - row.z)};
    for (const Point p : corners_of_side(b, c, f)) {
        const double along = tx * (p.x - row.x) + tz * (p.z - row.z);
        s.from = std::min(s.from, along);
        s.to = std::max(s.to, along);
    }
    return s;
}

Point undeformed(const Model& m, const Contact& c, const Face& f)
{
    const BlockPlace& place = m.places[f.b];
    const Point local = m.elements[place.element].points[c.b - place.first_point];
    return {m.layout.blocks[f.b].x0 + local.x, m.layout.blocks[f.b].z0 + local.z};
}

/// How far a block reaches from a face, along its normal to one side (+1 or -1) [m]. The ground
/// and the loading beam stand for more than is drawn of them.
double thickness_behind(const Model& m, int block, const Contact& c, const Face& f, double way)
{
    if (block == kGround || block == m.layout.beam) return kFar;
    double most = 0.0;
    for (const Point p : corners_of(m.layout.blocks[block]))
        most = std::max(most, way * (c.nx * (p.x - f.from.x) + c.nz * (p.z - f.from.z)));
    return most;
}

void add_pair(const Model& m, const std::vector<Contact>& contacts, int first, int count,
              FiniteTables& t)
{
    const Contact& c = contacts[first];
    const Face& f = m.layout.faces[c.face];
    FacePair p;
    p.a = f.a == kGround ? t.ground : f.a;
    p.b = f.b;
    p.nx = c.nx;
    p.nz = c.nz;
    p.side_a = side_of(m, t, f.a, c, f);
    p.side_b = side_of(m, t, f.b, c, f);
    p.length = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
    p.shallow = kShallow * std::max(p.length, m.layout.half_unit);
    p.deepest = std::max(p.shallow, kDeepest * std::min(thickness_behind(m, f.a, c, f, -1.0),
                                                        thickness_behind(m, f.b, c, f, 1.0)));
    t.pairs.push_back(p);
    const double tx = c.nz, tz = -c.nx;
    const double start = std::min(tx * f.from.x + tz * f.from.z, tx * f.to.x + tz * f.to.z);
    for (int k = first; k < first + count; ++k) {
        const Point at = undeformed(m, contacts[k], f);
        t.place.push_back((tx * at.x + tz * at.z - start) / p.length);
    }
}

/// A side of a block that can carry another, along the tangent of its normal.
struct Ledge {
    int block;
    Point normal, from, to;
    double level;       ///< along the normal [m]
    double start, stop; ///< along the tangent (nz, -nx) [m]
};

std::vector<Ledge> ledges_of(const Model& m)
{
    std::vector<Ledge> all;
    for (int b = 0; b < m.layout.beam; ++b) {
        const std::vector<Point> corners = corners_of(m.layout.blocks[b]);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point p = corners[i], q = corners[(i + 1) % corners.size()];
            const double length = std::hypot(q.x - p.x, q.z - p.z);
            const Point n{(q.z - p.z) / length, (p.x - q.x) / length};
            if (n.z <= kUpward) continue;
            const auto along = [n](Point at) { return n.z * at.x - n.x * at.z; };
            all.push_back({b, n, q, p, n.x * p.x + n.z * p.z, along(q), along(p)});
        }
    }
    return all;
}

bool has(const Ledge& l, Point p)
{
    return std::abs(l.normal.x * p.x + l.normal.z * p.z - l.level) < kOnLine;
}

bool on_one_line(const Ledge& a, const Ledge& b)
{
    return has(a, b.from) && has(a, b.to) &&
           a.normal.x * b.normal.x + a.normal.z * b.normal.z > kParallel;
}

/// The ledge that a pair lies on.
const Ledge* ledge_of(const Face& f, const std::vector<Ledge>& ledges)
{
    const Point middle{0.5 * (f.from.x + f.to.x), 0.5 * (f.from.z + f.to.z)};
    for (const Ledge& l : ledges) {
        if (l.block != f.a || l.normal.x * f.normal.x + l.normal.z * f.normal.z < kParallel)
            continue;
        const double at = l.normal.z * middle.x - l.normal.x * middle.z;
        if (at > l.start && at < l.stop && has(l, middle)) return &l;
    }
    return nullptr;
}

/// The pair of an upper block with a block that does not lie under it yet. The corner at which
/// the upper block arrives is rounded off, so that no elastic slip reaches it.
FacePair further_pair(const Model& m, const FiniteTables& t, const FacePair& home, bool far,
                      const Ledge& ledge)
{
    const Contact level{0, 0, home.nx, home.nz, 0.0, 0, 0};
    FacePair p = home;
    p.a = ledge.block;
    p.side_a = side_of(m, t, ledge.block, level,
                       Face{FaceKind::bed_joint,
                            0,
                            ledge.block,
                            home.b,
                            ledge.from,
                            ledge.to,
                            {home.nx, home.nz}});
    (far ? p.side_a.from : p.side_a.to) += (far ? 1.0 : -1.0) * kRoundedCorner * home.length;
    return p;
}

/// Furthers of one end of the blocks under an upper block: the nearest ledges on the same line.
void add_reach(const Model& m, int home, bool far, const Ledge& under,
               const std::vector<Ledge>& ledges, FiniteTables& t)
{
    std::vector<const Ledge*> beyond;
    for (const Ledge& l : ledges)
        if (l.block != t.pairs[home].b && on_one_line(l, under) &&
            (far ? l.start > under.stop - kOnLine : l.stop < under.start + kOnLine))
            beyond.push_back(&l);
    std::ranges::stable_sort(beyond, [far](const Ledge* a, const Ledge* b) {
        return far ? a->start < b->start : a->stop > b->stop;
    });
    if (beyond.size() > kReach) beyond.resize(kReach);
    if (beyond.empty()) return;
    t.reaches.push_back(
        {home, far, home, static_cast<int>(t.further.size()), static_cast<int>(beyond.size())});
    for (const Ledge* l : beyond)
        t.further.push_back(further_pair(m, t, t.pairs[home], far, *l));
}

/// Both ends of the dry joints under each block.
void add_reaches(const Model& m, const StepTables& tables, FiniteTables& t)
{
    const std::vector<Ledge> ledges = ledges_of(m);
    const int n = static_cast<int>(tables.dry.size());
    std::vector<const Ledge*> under(n, nullptr);
    for (int p = 0; p < n; ++p) {
        t.most_points = std::max(t.most_points, tables.dry[p].count);
        const Face& f = m.layout.faces[m.dry[tables.dry[p].first].face];
        if (f.a != kGround && f.normal.z > kUpward) under[p] = ledge_of(f, ledges);
    }
    std::vector<std::vector<int>> pairs_of(m.layout.blocks.size()); // as the upper block
    for (int p = 0; p < n; ++p)
        if (under[p] != nullptr) pairs_of[t.pairs[p].b].push_back(p);
    for (int p = 0; p < n; ++p) {
        if (under[p] == nullptr) continue;
        bool first = true, last = true;
        for (const int other : pairs_of[t.pairs[p].b]) {
            if (other == p || !on_one_line(*under[other], *under[p])) continue;
            first = first && under[other]->start >= under[p]->start;
            last = last && under[other]->start <= under[p]->start;
        }
        if (first) add_reach(m, p, false, *under[p], ledges, t);
        if (last) add_reach(m, p, true, *under[p], ledges, t);
    }
}

/// The load acts in the middle of the beam's top.
LoadPoint load_point(const Model& m, const FiniteTables& t)
{
    if (t.beam == t.ground) return {}; // no beam, and nothing on it
    const FiniteTables::BlockRow& beam = t.blocks[t.beam];
    const Block& b = m.layout.blocks[m.layout.beam];
    LoadPoint p;
    p.x = 0.5 * (b.x0 + b.x1);
    p.z = b.z1;
    p.above = b.z1 - beam.z;
    p.top = m.loads.top;
    p.link_length = m.loads.link_length;
    return p;
}

} // namespace

FiniteTables finite_tables(const Model& m, const StepTables& tables)
{
    FiniteTables t;
    const int n = static_cast<int>(m.layout.blocks.size());
    t.beam = m.layout.beam;
    t.ground = n;
    t.elastic.resize(m.elements.size());
    for (int b = 0; b < n; ++b) {
        t.blocks.push_back(block_row(m, b));
        const int element = m.places[b].element;
        t.elastic[element] = without(t.blocks[b].rigid, tables.matrices[element]);
        if (is_supported(m, b)) t.supported.push_back(b);
    }
    t.supported.push_back(t.ground);
    const auto add = [&](const std::vector<ContactRun>& runs, const std::vector<Contact>& list,
                         int first) {
        for (const ContactRun& r : runs) add_pair(m, list, r.first - first, r.count, t);
    };
    add(tables.dry, m.dry, 0);
    add(tables.tied, m.tied, tables.first_tied);
    add(tables.cracks, m.cracks, tables.first_crack);
    add_reaches(m, tables, t);
    t.load = load_point(m, t);
    t.load_area = m.layout.length * m.layout.thickness;
    return t;
}

} // namespace dem
