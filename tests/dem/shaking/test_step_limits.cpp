/// The largest time step of walls whose rigid motions have true masses.

#include "dem/shaking/step_limits.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/state/elastic_operator.hpp"
#include "dem/solver/state/wall_state.hpp"
#include "tests/dem/eigenvalues.hpp"
#include "tests/dem/shaken_blocks.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>

#include <cmath>
#include <numbers>

using namespace shaken_blocks;

namespace {

scenes::Scene floor_wall(double stress)
{
    scenes::Scene s = scenes::paper_wall(stress);
    s.loads.pattern = dem::LoadPattern::body;
    s.wall.toe = dem::Toe::free;
    return s;
}

struct Limited {
    dem::Model model;
    dem::WallMaterials wall;
    dem::StepTables tables;
    std::vector<dem::BlockMass> masses;
    dem::StepLimits limits;
};

Limited limited(const scenes::Scene& s, dem::Fidelity fidelity)
{
    dem::Model m = scenes::model_of(s, dem::discretisation_of(fidelity));
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    const auto masses = dem::true_masses(m, t, w, dem::LoadMass::floor);
    const dem::StepLimits limits = dem::step_limits(m, t, w, masses);
    return {std::move(m), w, t, masses, limits};
}

/// Frequencies of the wall in which nothing opens or slips, in rising order [rad/s].
/// @param elastic time step whose masses the elastic modes have [s]
Eigen::VectorXd frequencies(const Limited& w, double elastic)
{
    dem::SolverOptions options;
    options.step_fraction = 1.0;
    options.damping_factor = 0.0;
    dem::WallState<double> state =
        dem::unloaded<double>(w.model, w.tables, {&w.wall, 1}, options);
    const int n = w.model.n_modes;
    Eigen::MatrixXd k(n, n), mass = Eigen::MatrixXd::Zero(n, n);
    std::vector<double> q(n), force(n);
    for (int i = 0; i < n; ++i) {
        q.assign(n, 0.0);
        q[i] = 1.0;
        dem::apply_stiffness(w.tables, q, state, force);
        k.col(i) = Eigen::Map<const Eigen::VectorXd>(force.data(), n);
        mass(i, i) = elastic * elastic / state.laws.inv_mass[i];
    }
    for (std::size_t b = 0; b < w.masses.size(); ++b) {
        if (w.masses[b].mass == 0.0) continue;
        const int first = w.tables.blocks[b].first_mode;
        mass.block(first, first, 3, 3) =
            dem::modal_mass(w.model.elements[w.model.places[b].element], w.masses[b]);
    }
    const Eigen::LLT<Eigen::MatrixXd> root(mass);
    const Eigen::MatrixXd half = root.matrixL().solve(k);
    const Eigen::MatrixXd both = root.matrixL().solve(half.transpose().eval());
    return eigenvalues(0.5 * (both + both.transpose())).cwiseMax(0.0).cwiseSqrt();
}

} // namespace

TEST_CASE("step limits: the step of the paper's wall of rigid halves is that of its largest "
          "frequency",
          "[dem][shaking][step_limits]")
{
    struct Case {
        double stress, step; // MPa, us: 2 / omega_max
    };
    const auto c =
        GENERATE(values<Case>({{0.15, 80.81}, {0.50, 68.89}, {1.00, 58.15}, {1.25, 54.25}}));
    const dem::StepLimits limits = limited(floor_wall(c.stress), dem::Fidelity::rigid).limits;
    INFO("stress " << c.stress << " bound " << 1e6 * limits.bound);
    CHECK(1e6 * limits.whole == Approx(c.step).epsilon(2e-3));
    CHECK(limits.bound < 0.9 * limits.whole);
    CHECK(limits.bound > 0.8 * limits.whole);
}

TEST_CASE("step limits: elastic modes with fictitious masses hold up neither the step nor the "
          "frequencies",
          "[dem][shaking][step_limits]")
{
    const scenes::Scene s = floor_wall(0.50);
    const Limited w = limited(s, dem::Fidelity::simple);
    const double all_but_static = 0.02 * w.limits.elastic;
    const Eigen::VectorXd with = frequencies(w, w.limits.elastic),
                          without = frequencies(w, all_but_static);
    const double exact = 2.0 / with(with.size() - 1);
    CHECK(w.limits.whole == Approx(exact).epsilon(2e-3));
    CHECK(w.limits.whole <= exact);
    CHECK(w.limits.whole > 0.95 * limited(s, dem::Fidelity::rigid).limits.whole);
    for (int i = 0; i < 8; ++i) {
        const double hertz = without(i) / (2.0 * std::numbers::pi);
        INFO("frequency " << i + 1 << ": " << hertz << " Hz");
        CHECK(with(i) <= without(i));
        // The seventh has more of the elasticity of blocks than the others.
        CHECK(with(i) == Approx(without(i)).epsilon(i == 6 ? 3.5e-3 : 3e-4));
    }
}

TEST_CASE("step limits: without dashpots a history steps by a quarter of a contact's own limit",
          "[dem][shaking][step_limits]")
{
    const scenes::Scene s = block(0.2, 0.6);
    const dem::Model m = model(s);
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    const dem::ShakePlan plan = half_sine(1.0, 2.0, 40);
    const double contact =
        dem::step_limits(m, t, w, dem::true_masses(m, t, w, plan.load)).contact;
    const double step = dem::shake(m, w, plan).time_step;
    CHECK(step <= 0.25 * contact);
    CHECK(plan.step / step == Approx(std::ceil(plan.step / (0.25 * contact)))); // no smaller
}
