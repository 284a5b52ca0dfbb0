#include "bench/nodal/nodal_wall.hpp"

#include "dem/solver/state/lane_laws.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bench {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

dem::DryLaw<double> dry_law(const dem::JointMaterial& j)
{
    return {j.kn, j.ks, 1.0 / j.ks, j.tan_phi};
}

dem::CrackState<double> uncracked(const dem::CrackLaw<double>& law) { return dem::intact(law); }

const dem::JointMaterial& joint_of(const dem::WallMaterials& w, const dem::Contact& c)
{
    if (c.material == dem::kBaseMaterial) return w.base_joint;
    return c.material == dem::kBeamMaterial ? w.beam_joint : w.joints[c.material];
}

void link_contacts(const dem::Model& m, const dem::WallMaterials& w, NodalWall& n)
{
    const auto dry = [&w](const dem::Contact& c) -> DryLink {
        return {2 * c.a, 2 * c.b, c.nx, c.nz, c.area, dry_law(joint_of(w, c)), {0.0, 0.0}};
    };
    for (const dem::Contact& c : m.dry) n.dry.push_back(dry(c));
    for (const dem::Contact& c : m.tied) n.tied.push_back(dry(c));
    for (const dem::Contact& c : m.cracks) {
        const dem::CrackLaw<double> law = dem::crack_law(w.cracks[c.material]);
        n.cracks.push_back({2 * c.a, 2 * c.b, c.nx, c.nz, c.area, law, uncracked(law)});
    }
}

/// Twice the stiffness of the contacts on each row: what a spring between two nodes adds to the
/// absolute sum of its row.
std::vector<double> contact_rows(const NodalWall& n)
{
    std::vector<double> sum(n.v.size(), 0.0);
    const auto add = [&sum](const auto& c) {
        for (const int row : {c.a, c.b}) {
            sum[row] += 2.0 * c.area * (c.law.kn * c.nx * c.nx + c.law.ks * c.nz * c.nz);
            sum[row + 1] += 2.0 * c.area * (c.law.kn * c.nz * c.nz + c.law.ks * c.nx * c.nx);
        }
    };
    std::for_each(n.dry.begin(), n.dry.end(), add);
    std::for_each(n.tied.begin(), n.tied.end(), add);
    std::for_each(n.cracks.begin(), n.cracks.end(), add);
    return sum;
}

/// Modal amplitudes of the displacements of the points, Phi being square on the rows that no
/// support holds: q = P u, so K = P^T Lambda P, and the nodal loads of a modal load are P^T f.
MatrixXd amplitudes(const dem::BlockElement& e)
{
    std::vector<Index> open;
    for (Index i = 0; i < e.phi.rows(); ++i)
        if (!e.phi.row(i).isZero(0.0)) open.push_back(i);
    if (static_cast<Index>(open.size()) != e.phi.cols())
        throw std::invalid_argument(
            "nodal scheme: the model must keep all modes of its blocks");
    const MatrixXd phi = e.phi(open, Eigen::all), inverse = phi.inverse();
    MatrixXd p = MatrixXd::Zero(e.phi.cols(), e.phi.rows());
    p(Eigen::all, open) = inverse;
    return p;
}

void place_stone(const dem::Model& m, const dem::WallMaterials& w, double mass_factor,
                 NodalWall& n)
{
    const std::vector<double> contacts = contact_rows(n);
    const double softer = w.stone.young_modulus / m.stone.young_modulus;
    n.stiffness.resize(m.elements.size());
    for (int block = 0; block < m.layout.beam; ++block) { // the beam comes last
        const dem::BlockPlace& place = m.places[block];
        const dem::BlockElement& e = m.elements[place.element];
        const MatrixXd p = amplitudes(e);
        const VectorXd f = p.transpose() * (w.stone.density * m.loads.gravity * e.weight);
        const MatrixXd k = softer * p.transpose() * e.lambda.asDiagonal() * p;
        n.stiffness[place.element] = k;
        n.blocks.push_back({place.element, 2 * place.first_point, static_cast<int>(k.rows())});
        for (Index i = 0; i < k.rows(); ++i) {
            const bool held = e.phi.row(i).isZero(0.0);
            const double row_sum = k.row(i).cwiseAbs().sum() + contacts[n.load.size()];
            n.load.push_back(f(i));
            n.inv_mass.push_back(held ? 0.0 : 4.0 / (mass_factor * row_sum));
        }
    }
    n.u.assign(n.load.size(), 0.0);
    n.last_force = n.u;
}

/// Modal masses by the bound of dem/block/block_element.hpp.
void place_beam(const dem::Model& m, const dem::WallMaterials& w, double mass_factor,
                ModalBeam& beam)
{
    const dem::BlockPlace& place = m.places[m.layout.beam];
    const dem::BlockElement& e = m.elements[place.element];
    const double ratio = std::max(w.beam_joint.kn / m.reference.joint.kn,
                                  w.beam_joint.ks / m.reference.joint.ks);
    beam.first = 2 * place.first_point;
    beam.phi = e.phi;
    beam.lambda = e.lambda;
    beam.load = m.beam.material.density * m.loads.gravity * e.weight +
                m.loads.vertical_stress * e.top_load;
    beam.inv_mass = 4.0 / (mass_factor * (e.lambda.array() + 2.0 * ratio));
    beam.q = beam.v = beam.last_force = VectorXd::Zero(e.lambda.size());
}

} // namespace

NodalWall unloaded_nodes(const dem::Model& m, const dem::WallMaterials& w, double mass_factor)
{
    if (static_cast<int>(w.joints.size()) != m.layout.n_joints ||
        static_cast<int>(w.cracks.size()) != m.layout.n_cracks)
        throw std::invalid_argument("nodal scheme: one material per joint and crack ID");
    NodalWall n;
    n.v.assign(2 * static_cast<std::size_t>(m.n_points) + 2, 0.0);
    n.force = n.v;
    link_contacts(m, w, n);
    place_stone(m, w, mass_factor, n);
    place_beam(m, w, mass_factor, n.beam);
    return n;
}

} // namespace bench
