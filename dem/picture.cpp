#include "dem/picture.hpp"

namespace dem {

namespace {

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
        const double pushed = block == m.layout.beam ? drive : 0.0;
        const auto row = 2 * static_cast<Eigen::Index>(p);
        s.displacement.push_back({u(row) + pushed, u(row + 1)});
    }
    return s;
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

/// Undeformed position of a contact point, from the block above or right of it.
Point position_of(const Model& m, const Contact& c, const Face& f)
{
    const BlockPlace& place = m.places[f.b];
    const Point local = m.elements[place.element].points[c.b - place.first_point];
    return {m.layout.blocks[f.b].x0 + local.x, m.layout.blocks[f.b].z0 + local.z};
}

/// Displacements of all contact points (x and z in turn), the ground last [m].
template <class Real>
std::vector<double> point_displacements(const Model& m, const StepTables& t,
                                        const WallState<Real>& state, int lane, double drive)
{
    std::vector<double> u(2 * static_cast<std::size_t>(m.n_points) + 2, 0.0);
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        const auto& block = t.blocks[b];
        const Eigen::MatrixXd& phi = m.elements[block.element].phi;
        const double pushed = static_cast<int>(b) == m.layout.beam ? drive : 0.0;
        for (int row = 0; row < block.rows; ++row) {
            double sum = row % 2 == 0 ? pushed : 0.0;
            for (int i = 0; i < block.modes; ++i)
                sum += phi(row, i) * dem::lane(state.q[block.first_mode + i], lane);
            u[block.first_row + row] = sum;
        }
    }
    return u;
}

void add_contact(const Model& m, const Contact& c, const std::vector<double>& u,
                 ContactState state, Snapshot& s)
{
    const int a = 2 * c.a, b = 2 * c.b;
    state.slip = c.nz * (u[b] - u[a]) - c.nx * (u[b + 1] - u[a + 1]);
    state.at = position_of(m, c, m.layout.faces[c.face]);
    state.area = c.area;
    s.faces[c.face].normal = {c.nx, c.nz};
    s.faces[c.face].contacts.push_back(state);
}

} // namespace

template <class Real>
Snapshot picture(const Model& m, const StepTables& t, const WallState<Real>& state, int lane,
                 double drive, double force)
{
    const auto at = [lane](const Real& x) { return dem::lane(x, lane); };
    Snapshot s;
    s.displacement = drive;
    s.force = force;
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) {
        Eigen::VectorXd q(t.blocks[b].modes);
        for (int i = 0; i < t.blocks[b].modes; ++i)
            q(i) = at(state.q[t.blocks[b].first_mode + i]);
        s.blocks.push_back(block_state(m, q, b, drive));
    }
    s.faces = empty_faces(m.layout);
    const std::vector<double> u = point_displacements(m, t, state, lane, drive);
    for (std::size_t k = 0; k < m.dry.size(); ++k) {
        const double sigma = at(dry_stress(state.dry_laws[t.dry[k].law], state.dry[k].u_n));
        add_contact(m, m.dry[k], u,
                    {{}, 0, at(state.dry[k].u_n), 0, sigma, at(state.dry[k].tau), 0}, s);
    }
    for (std::size_t k = 0; k < m.tied.size(); ++k) {
        const double u_n = at(state.tied[k].u_n);
        add_contact(m, m.tied[k], u,
                    {{}, 0, u_n, 0, at(state.tied_laws[0].kn) * u_n, at(state.tied[k].tau), 0},
                    s);
    }
    for (std::size_t k = 0; k < m.cracks.size(); ++k) {
        const CrackState<Real>& c = state.cracks[k];
        const double d = at(damage(state.crack_laws[t.cracks[k].law], c));
        add_contact(m, m.cracks[k], u, {{}, 0, at(c.u_n), 0, at(c.sigma), at(c.tau), d}, s);
    }
    return s;
}

template Snapshot picture(const Model&, const StepTables&, const WallState<double>&, int,
                          double, double);
template Snapshot picture(const Model&, const StepTables&, const WallState<Pack>&, int, double,
                          double);

} // namespace dem
