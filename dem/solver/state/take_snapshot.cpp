#include "dem/solver/state/take_snapshot.hpp"

#include "dem/block/model.hpp"
#include "dem/kinematics/overlap.hpp"
#include "dem/solver/state/elastic_operator.hpp"

namespace dem {

namespace {

/// Displacement of a point that has been deformed by u in the frame of its block.
Point displacement(const FiniteTables::BlockRow& row, const BlockFrame<double>& frame, Point at,
                   Point u)
{
    const Turn<double> turn = whole(frame.half);
    const double rx = at.x + u.x - row.x, rz = at.z + u.z - row.z;
    return {frame.x + rx * turn.c + rz * turn.s - at.x,
            frame.z + rz * turn.c - rx * turn.s - at.z};
}

BlockState block_state(const Model& m, const Eigen::VectorXd& q, int block, double drive)
{
    const Block& b = m.layout.blocks[block];
    const BlockElement& e = m.elements[m.places[block].element];
    const Eigen::VectorXd u = e.outline_phi * q;
    BlockState s;
    s.course = b.course;
    s.unit = b.unit;
    for (std::size_t p = 0; p < e.outline.size(); ++p) {
        s.outline.push_back({b.x0 + e.outline[p].x, b.z0 + e.outline[p].z});
        const bool driven = m.loads.pattern == LoadPattern::beam && block == m.layout.beam;
        const double pushed = driven ? drive : 0.0;
        const auto row = 2 * static_cast<Eigen::Index>(p);
        s.displacement.push_back({u(row) + pushed, u(row + 1)});
    }
    return s;
}

/// Adds the motion of the frame to the displacements of a block in it.
void turn_with(const FiniteTables::BlockRow& row, const BlockFrame<double>& frame,
               BlockState& b)
{
    for (std::size_t p = 0; p < b.outline.size(); ++p)
        b.displacement[p] = displacement(row, frame, b.outline[p], b.displacement[p]);
}

template <class Real> BlockFrame<double> frame_of(const BlockFrame<Real>& f, int lane)
{
    BlockFrame<double> one;
    one.x = dem::lane(f.x, lane);
    one.z = dem::lane(f.z, lane);
    one.half = {dem::lane(f.half.c, lane), dem::lane(f.half.s, lane)};
    return one;
}

std::vector<FaceState> empty_faces(const Layout& layout)
{
    std::vector<FaceState> faces;
    for (const Face& f : layout.faces) {
        FaceState s;
        s.kind = f.kind;
        s.id = f.id;
        s.block_a = f.a;
        s.block_b = f.b;
        faces.push_back(s);
    }
    return faces;
}

/// Undeformed position of a contact point, taken from the block above it or on its right.
Point position_of(const Model& m, const Contact& c, const Face& f)
{
    const BlockPlace& place = m.places[f.b];
    const Point local = m.elements[place.element].points[c.b - place.first_point];
    return {m.layout.blocks[f.b].x0 + local.x, m.layout.blocks[f.b].z0 + local.z};
}

/// Slip of the contacts of one lane since the unloaded wall [m].
template <class Real>
std::vector<double> slips(const StepTables& t, const WallState<Real>& state, int lane,
                          double drive)
{
    std::vector<double> q, du(state.du.size()), slip;
    for (const Real& x : state.q) q.push_back(dem::lane(x, lane));
    stretch(t, q, du);
    for (int k = 0; k < t.n_contacts; ++k) slip.push_back(du[2 * k + 1]);
    if (state.finite.frames.empty()) {
        for (const HorizontalShare& h : t.beam)
            if (h.row % 2 == 1) slip[h.row / 2] += h.factor * drive;
        return slip;
    }
    std::size_t pair = 0;
    for (const auto* runs : {&t.dry, &t.tied, &t.cracks})
        for (const ContactRun& run : *runs) {
            const double together = dem::lane(state.finite.pairs[pair++].slip, lane);
            for (int k = run.first; k < run.first + run.count; ++k) slip[k] += together;
        }
    return slip;
}

/// Faces of blocks that have moved: the direction in which add_forces() has stresses act.
template <class Real>
void set_acting(const StepTables& t, const WallState<Real>& state, int lane, const Model& m,
                Snapshot& s)
{
    std::size_t p = 0;
    const auto set = [&](const std::vector<ContactRun>& runs,
                         const std::vector<Contact>& contacts, int first) {
        for (const ContactRun& run : runs) {
            const FacePair& pair = t.finite.pairs[p];
            const auto& now = state.finite.pairs[p++];
            const auto o = overlap_of(pair, frame_of(state.finite.frames[pair.a], lane),
                                      frame_of(state.finite.frames[pair.b], lane),
                                      dem::lane(now.centre, lane));
            const double share = dem::lane(now.share, lane);
            s.faces[contacts[run.first - first].face].acting = {share * (o.nx + o.tilt * o.nz),
                                                                share * (o.nz - o.tilt * o.nx)};
        }
    };
    set(t.dry, m.dry, 0);
    set(t.tied, m.tied, static_cast<int>(m.dry.size()));
    set(t.cracks, m.cracks, t.first_crack);
}

/// Contacts stand in the faces in the order of their numbers.
template <class Real>
void set_strength_lost(const StepTables& t, const WallState<Real>& state, int lane,
                       const Model& m, Snapshot& s)
{
    const auto set = [&](const std::vector<ContactRun>& runs, const auto& laws,
                         const std::vector<Contact>& contacts, int first) {
        for (const ContactRun& run : runs) {
            const auto& law = laws[run.law];
            const CrushingLaw<double> one{
                dem::lane(law.kn, lane), dem::lane(law.strength, lane),
                dem::lane(law.softening, lane), dem::lane(law.flow, lane)};
            FaceState& face = s.faces[contacts[run.first - first].face];
            for (ContactState& c : face.contacts) c.crushing = strength_lost(one, c.crushed);
        }
    };
    set(t.dry, state.laws.dry_crushing, m.dry, 0);
    set(t.cracks, state.laws.crack_crushing, m.cracks, t.first_crack);
}

template <class Real>
BlockState block_now(const Model& m, const StepTables& t, const WallState<Real>& state,
                     int lane, int block, double drive)
{
    Eigen::VectorXd q(t.blocks[block].modes);
    for (int i = 0; i < t.blocks[block].modes; ++i)
        q(i) = dem::lane(state.q[t.blocks[block].first_mode + i], lane);
    const bool finite = !state.finite.frames.empty();
    BlockState s = block_state(m, q, block, finite ? 0.0 : drive);
    if (finite)
        turn_with(t.finite.blocks[block], frame_of(state.finite.frames[block], lane), s);
    return s;
}

} // namespace

template <class Real>
double corner_displacement(const Model& m, const StepTables& t, const WallState<Real>& state,
                           int lane, double drive)
{
    const std::vector<Block>& blocks = m.layout.blocks;
    std::size_t top_right = 0;
    for (std::size_t k = 0; k < blocks.size(); ++k)
        if (blocks[k].x1 + blocks[k].z1 >= blocks[top_right].x1 + blocks[top_right].z1)
            top_right = k;
    const BlockState b = block_now(m, t, state, lane, static_cast<int>(top_right), drive);
    std::size_t corner = 0;
    for (std::size_t p = 0; p < b.outline.size(); ++p)
        if (b.outline[p].x + b.outline[p].z > b.outline[corner].x + b.outline[corner].z)
            corner = p;
    return b.displacement[corner].x;
}

template <class Real>
Snapshot take_snapshot(const Model& m, const StepTables& t, const WallState<Real>& state,
                       int lane, double drive, double force)
{
    Snapshot s = take_faces(m, t, state, lane, drive, force);
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b)
        s.blocks.push_back(block_now(m, t, state, lane, b, drive));
    return s;
}

template <class Real>
Snapshot take_faces(const Model& m, const StepTables& t, const WallState<Real>& state, int lane,
                    double drive, double force)
{
    const auto at = [lane](const Real& x) { return dem::lane(x, lane); };
    Snapshot s;
    s.displacement = drive;
    s.force = force;
    s.faces = empty_faces(m.layout);
    const std::vector<double> slip = slips(t, state, lane, drive);
    int number = 0;
    const auto add = [&](const Contact& c, double damage) {
        const int k = number++;
        s.faces[c.face].normal = s.faces[c.face].acting = {c.nx, c.nz};
        ContactState one{position_of(m, c, m.layout.faces[c.face]),
                         c.area,
                         at(state.u_n[k]),
                         slip[k],
                         at(state.stress[2 * k]),
                         at(state.stress[2 * k + 1]),
                         damage};
        if (!state.crushed.empty()) {
            one.crushed = at(state.crushed[k]);
            one.opening -= one.crushed;
        }
        one.mean_sigma = one.sigma;
        one.mean_tau = one.tau;
        s.faces[c.face].contacts.push_back(one);
    };
    for (const Contact& c : m.dry) add(c, 0.0);
    for (const Contact& c : m.tied) add(c, 0.0);
    for (const Contact& c : m.cracks)
        add(c, at(damage(state.laws.cracks[c.material], crack_state(t, state, number))));
    if (!state.crushed.empty()) set_strength_lost(t, state, lane, m, s);
    if (!state.finite.frames.empty()) set_acting(t, state, lane, m, s);
    return s;
}

template Snapshot take_snapshot(const Model&, const StepTables&, const WallState<double>&, int,
                                double, double);
template Snapshot take_snapshot(const Model&, const StepTables&, const WallState<Pack>&, int,
                                double, double);
template Snapshot take_faces(const Model&, const StepTables&, const WallState<double>&, int,
                             double, double);
template Snapshot take_faces(const Model&, const StepTables&, const WallState<Pack>&, int,
                             double, double);
template double corner_displacement(const Model&, const StepTables&, const WallState<double>&,
                                    int, double);
template double corner_displacement(const Model&, const StepTables&, const WallState<Pack>&,
                                    int, double);

} // namespace dem
