#include "uq/reliability/simulation/subset_simulation_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace uq {

namespace {

constexpr double kAcceptance = 0.44; // [-] Papaioannou et al. (2015), section 3.3

Eigen::VectorXd values(const LimitState& s, const Eigen::MatrixXd& u, FailedAs failed,
                       Ledger& ledger)
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double instead = failed == FailedAs::safe ? inf : -inf;
    Eigen::VectorXd g = limit_values(s, u, ledger);
    for (double& v : g)
        if (std::isnan(v)) v = instead;
    return g;
}

/// Standard deviation of each column, at most 1; 1 if there is a single row.
Eigen::RowVectorXd spread(const Eigen::MatrixXd& u)
{
    if (u.rows() < 2) return Eigen::RowVectorXd::Ones(u.cols());
    const Eigen::MatrixXd off = u.rowwise() - u.colwise().mean();
    const Eigen::RowVectorXd sd =
        (off.colwise().squaredNorm() / static_cast<double>(u.rows() - 1)).cwiseSqrt();
    return sd.cwiseMax(1e-3).cwiseMin(1.0); // a column that never differs must stay movable
}

/// rho u + sqrt(1 - rho^2) xi, which leaves the standard normal distribution as it is.
Eigen::MatrixXd moved(const Eigen::MatrixXd& u, const Eigen::RowVectorXd& sd, ChainState& state)
{
    const Eigen::RowVectorXd sigma = (state.scale * sd).cwiseMin(1.0);
    const Eigen::RowVectorXd rho = (1.0 - sigma.array().square()).sqrt();
    Eigen::MatrixXd v(u.rows(), u.cols());
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        Stream random(state.seed, state.drawn++, Purpose::markov_chain);
        for (Eigen::Index j = 0; j < u.cols(); ++j)
            v(i, j) = rho(j) * u(i, j) + sigma(j) * random.normal();
    }
    return v;
}

} // namespace

Population first_population(const LimitState& s, std::size_t n, FailedAs failed,
                            ChainState& state, Ledger& ledger)
{
    Population p;
    p.u = Eigen::MatrixXd(static_cast<Eigen::Index>(n), s.dimension);
    for (Eigen::Index i = 0; i < p.u.rows(); ++i) {
        Stream random(state.seed, state.drawn++, Purpose::markov_chain);
        for (double& v : p.u.row(i)) v = random.normal();
    }
    p.g = values(s, p.u, failed, ledger);
    p.ancestor.resize(n);
    std::iota(p.ancestor.begin(), p.ancestor.end(), Eigen::Index{0});
    return p;
}

Population next_population(const LimitState& s, const Population& p,
                           const std::vector<Eigen::Index>& seeds, double threshold,
                           FailedAs failed, ChainState& state, Ledger& ledger)
{
    const Eigen::Index n = p.u.rows(), chains = static_cast<Eigen::Index>(seeds.size());
    const Eigen::Index length = n / chains;
    Population next{Eigen::MatrixXd(n, p.u.cols()), Eigen::VectorXd(n), {}};
    Eigen::MatrixXd u = p.u(seeds, Eigen::all);
    Eigen::VectorXd g = p.g(seeds);
    const Eigen::RowVectorXd sd = spread(u);
    Eigen::Index accepted = 0;
    for (Eigen::Index step = 0; step < length; ++step) {
        if (step > 0) {
            const Eigen::MatrixXd v = moved(u, sd, state);
            const Eigen::VectorXd gv = values(s, v, failed, ledger);
            Eigen::Index now = 0;
            for (Eigen::Index i = 0; i < chains; ++i) {
                if (gv(i) > threshold) continue;
                u.row(i) = v.row(i);
                g(i) = gv(i);
                ++now;
            }
            accepted += now;
            const double rate = static_cast<double>(now) / static_cast<double>(chains);
            state.scale *=
                std::exp((rate - kAcceptance) / std::sqrt(static_cast<double>(step)));
            state.scale = std::clamp(state.scale, 1e-3, 1e3);
        }
        next.u.middleRows(step * chains, chains) = u;
        next.g.segment(step * chains, chains) = g;
        for (const Eigen::Index i : seeds)
            next.ancestor.push_back(p.ancestor[static_cast<std::size_t>(i)]);
    }
    state.acceptance =
        static_cast<double>(accepted) / static_cast<double>(chains * (length - 1));
    return next;
}

} // namespace uq
