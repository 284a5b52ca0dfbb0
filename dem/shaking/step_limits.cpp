#include "dem/shaking/step_limits.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/state/lane_laws.hpp"
#include "dem/solver/state/wall_state.hpp"
#include "dem/solver/step/stability_limit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {

namespace {

/// Elastic modes are so much slower than the bound lets them be that they do not hold up the
/// step of the wall, and so much quicker than what an earthquake moves that its frequencies
/// keep their place (docs/dynamics.md).
constexpr double kElasticStep = 1.2;
constexpr double kLanczosError = 1e-3; // of largest_frequency()

/// R with R R^T = M^-1.
MassRoots mass_roots(const Model& m, const StepTables& t, const std::vector<BlockMass>& masses,
                     const std::vector<double>& inverse_elastic)
{
    MassRoots roots;
    for (const double inverse : inverse_elastic) roots.modes.push_back(std::sqrt(inverse));
    for (std::size_t b = 0; b < masses.size(); ++b) {
        if (masses[b].mass <= 0.0) continue;
        const int first = t.blocks[b].first_mode;
        const Eigen::LLT<Eigen::Matrix3d> root(
            modal_mass(m.elements[m.places[b].element], masses[b]));
        roots.rigid.push_back(
            {first, root.matrixU().solve(Eigen::Matrix3d::Identity().eval())});
        std::fill_n(roots.modes.begin() + first, 3, 1.0);
    }
    return roots;
}

double whole_limit(const Model& m, const StepTables& t, const WallMaterials& w,
                   const std::vector<BlockMass>& masses, double elastic)
{
    SolverOptions options;
    options.step_fraction = 1.0;
    options.damping_factor = 0.0;
    WallState<double> wall = unloaded<double>(m, t, {&w, 1}, options);
    std::vector<double> inverse = wall.laws.inv_mass;
    for (double& x : inverse) x /= elastic * elastic;
    const MassRoots roots = mass_roots(m, t, masses, inverse);
    return 2.0 / ((1.0 + kLanczosError) * largest_frequency(t, roots, wall));
}

} // namespace

double reduced_mass(const std::array<int, 2>& blocks, const std::vector<BlockMass>& masses)
{
    double inverse = 0.0;
    for (const int b : blocks)
        if (b != kGround && masses[b].mass > 0.0) inverse += 1.0 / masses[b].mass;
    return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

double normal_stiffness(const StepTables& t, std::size_t run, const WallMaterials& w,
                        const Model& m)
{
    const ContactRun& r = t.dry[run];
    double area = 0.0;
    for (int k = r.first; k < r.first + r.count; ++k) area += t.area[k];
    const JointMaterial& j = r.law < m.layout.n_joints    ? w.joints[r.law]
                             : r.law == m.layout.n_joints ? w.base_joint
                                                          : w.beam_joint;
    return area * j.kn;
}

StepLimits step_limits(const Model& m, const StepTables& t, const WallMaterials& w,
                       const std::vector<BlockMass>& masses, double stiffer)
{
    StepLimits limits;
    limits.bound = limits.contact = std::numeric_limits<double>::infinity();
    const std::vector<double> ratio = stiffness_ratio(m, w);
    for (std::size_t b = 0; b < masses.size(); ++b) {
        double limit = std::numeric_limits<double>::infinity();
        if (masses[b].mass > 0.0) {
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
                modal_mass(m.elements[m.places[b].element], masses[b]));
            limit = std::sqrt(2.0 * solver.eigenvalues()(0) / (stiffer * ratio[b]));
        }
        limits.block.push_back(limit);
        limits.bound = std::min(limits.bound, limit);
    }
    for (std::size_t r = 0; r < t.dry.size(); ++r) {
        const double mass = reduced_mass(t.dry_blocks[r], masses);
        if (mass > 0.0)
            limits.contact =
                std::min(limits.contact,
                         2.0 * std::sqrt(mass / (stiffer * normal_stiffness(t, r, w, m))));
    }
    limits.elastic = kElasticStep * limits.bound;
    limits.whole = limits.bound;
    if (m.layout.closure == Closure::linear)
        limits.whole = std::max(limits.bound, whole_limit(m, t, w, masses, limits.elastic));
    return limits;
}

} // namespace dem
