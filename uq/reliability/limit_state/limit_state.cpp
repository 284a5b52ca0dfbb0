#include "uq/reliability/limit_state/limit_state.hpp"

#include "uq/reliability/limit_state/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace uq {

void check(const LimitState& s)
{
    const auto refuse = [](const std::string& why) {
        throw std::invalid_argument("limit state: " + why);
    };
    if (!s.model) refuse("there is no model");
    if (s.dimension < 1)
        refuse("dimension is " + std::to_string(s.dimension) + ", must be at least 1");
    if (s.response < 0)
        refuse("response is " + std::to_string(s.response) + ", must be at least 0");
    if (!std::isfinite(s.threshold)) refuse("threshold must be finite");
}

namespace {

Eigen::VectorXd asked_values(const LimitState& s, const Eigen::MatrixXd& u, Ledger& ledger)
{
    const Eigen::Index n = u.rows();
    if (n == 0) return {};
    if (static_cast<std::size_t>(n) >
        ledger.limit - std::min(ledger.limit, ledger.evaluations)) {
        ledger.used_up = true;
        return Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    }
    Samples samples{s.to_physical ? s.to_physical(u) : u,
                    std::vector<std::uint64_t>(static_cast<std::size_t>(n))};
    std::iota(samples.id.begin(), samples.id.end(),
              static_cast<std::uint64_t>(ledger.evaluations));
    const Responses r = evaluate(s.model, samples, s.response + 1);
    ledger.evaluations += static_cast<std::size_t>(n);
    ++ledger.batches;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto row = static_cast<std::size_t>(i);
        if (r.failure[row].empty()) continue;
        ledger.failed.push_back({samples.id[row], samples.x.row(i), r.failure[row]});
    }
    const double sign = s.passing == Passing::at_or_below ? 1.0 : -1.0;
    return sign * (r.y.col(s.response).array() - s.threshold);
}

/// Asks for the rows that are not known yet, each once.
Eigen::VectorXd recalled_values(const LimitState& s, const Eigen::MatrixXd& u, Ledger& ledger)
{
    const auto point = [&](Eigen::Index i) {
        const Eigen::VectorXd row = u.row(i);
        return std::vector<double>(row.begin(), row.end());
    };
    std::set<std::vector<double>> seen;
    std::vector<Eigen::Index> fresh;
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        if (!ledger.known->contains(point(i)) && seen.insert(point(i)).second)
            fresh.push_back(i);
    const Eigen::VectorXd g = asked_values(s, u(fresh, Eigen::all), ledger);
    if (ledger.used_up)
        return Eigen::VectorXd::Constant(u.rows(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < fresh.size(); ++k)
        (*ledger.known)[point(fresh[k])] = g(static_cast<Eigen::Index>(k));
    Eigen::VectorXd all(u.rows());
    for (Eigen::Index i = 0; i < u.rows(); ++i) all(i) = ledger.known->at(point(i));
    return all;
}

} // namespace

Eigen::VectorXd limit_values(const LimitState& s, const Eigen::MatrixXd& u, Ledger& ledger)
{
    return ledger.known ? recalled_values(s, u, ledger) : asked_values(s, u, ledger);
}

} // namespace uq
