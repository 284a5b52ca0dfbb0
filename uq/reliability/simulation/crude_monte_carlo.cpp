#include "uq/reliability/simulation/crude_monte_carlo.hpp"

#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace uq {

namespace {

void check_options(const MonteCarloOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("monte carlo: " + what);
    };
    require(o.batch >= 1, "batch must be at least 1");
    require(o.max_samples >= 1, "max_samples must be at least 1");
    require(o.target_cov > 0.0, "target_cov must be > 0");
    require(o.confidence > 0.0 && o.confidence < 1.0, "confidence must be in (0, 1)");
}

} // namespace

Eigen::MatrixXd normal_rows(std::uint64_t seed, std::size_t first, std::size_t n,
                            Eigen::Index dimension)
{
    Eigen::MatrixXd u(static_cast<Eigen::Index>(n), dimension);
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        Stream random(seed, first + static_cast<std::size_t>(i), Purpose::monte_carlo);
        for (Eigen::Index j = 0; j < dimension; ++j) u(i, j) = random.normal();
    }
    return u;
}

Exceedance crude_monte_carlo(const LimitState& s, const MonteCarloOptions& o)
{
    check(s);
    check_options(o);
    Ledger ledger;
    Exceedance e;
    std::size_t passed = 0;
    while (ledger.evaluations < o.max_samples) {
        const std::size_t n = std::min(o.batch, o.max_samples - ledger.evaluations);
        const Eigen::VectorXd g =
            limit_values(s, normal_rows(o.seed, ledger.evaluations, n, s.dimension), ledger);
        passed += static_cast<std::size_t>((g.array() <= 0.0).count()); // NaN is not
        e = count_exceedance(passed, ledger.failed.size(), ledger.evaluations, o.confidence);
        if (e.outcome == SamplingOutcome::limit_reached &&
            coefficient_of_variation(e.estimate) <= o.target_cov) {
            e.outcome = SamplingOutcome::target_reached;
            break;
        }
    }
    e.ledger = std::move(ledger);
    return e;
}

} // namespace uq
