#include "uq/sensitivity/rank_index.hpp"

#include "core/moments.hpp"
#include "core/normal.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace uq {

namespace {

/// n times the variance of the index where y does not depend on x, with phi = min(F(y), F(y')):
///   (E phi^2 - 2 E[E(phi | y)^2] + (E phi)^2) / (E[G (1 - G)])^2,  G(t) = P(Y >= t)
double chance_variance(const Eigen::VectorXd& y)
{
    std::vector<double> sorted(y.begin(), y.end());
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) return 0.4;
    const auto n = static_cast<double>(sorted.size());
    double square = 0.0, mean = 0.0, product = 0.0, below = 0.0, spread = 0.0, above = n;
    for (const double v : sorted) {
        const auto up_to =
            static_cast<double>(std::ranges::upper_bound(sorted, v) - sorted.begin());
        const auto from =
            static_cast<double>(sorted.end() - std::ranges::lower_bound(sorted, v));
        const double f = up_to / n;
        above -= 1.0;
        const double pairs = (2.0 * above + 1.0) / (n * n); // whose smaller sample this is
        square += pairs * f * f;
        mean += pairs * f;
        below += f;
        const double row = (below + above * f) / n;
        product += row * row / n;
        spread += from * (n - from) / (n * n * n);
    }
    return (square - 2.0 * product + mean * mean) / (spread * spread);
}

} // namespace

double raw_rank_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    const auto n = static_cast<std::size_t>(y.size());
    std::vector<double> sorted(y.begin(), y.end());
    std::ranges::sort(sorted);
    std::vector<Eigen::Index> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return x(i); });
    double jumps = 0.0, scatter = 0.0, before = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        const double here = y(order[k]);
        const auto up_to =
            static_cast<double>(std::ranges::upper_bound(sorted, here) - sorted.begin());
        const auto from =
            static_cast<double>(sorted.end() - std::ranges::lower_bound(sorted, here));
        if (k > 0) jumps += std::abs(up_to - before);
        scatter += from * (static_cast<double>(n) - from);
        before = up_to;
    }
    return scatter > 0.0 ? 1.0 - static_cast<double>(n) * jumps / (2.0 * scatter) : 0.0;
}

double independence_p(const Estimate& e, const Eigen::VectorXd& y)
{
    return core::normal_survival(e.value *
                                 std::sqrt(static_cast<double>(e.n) / chance_variance(y)));
}

Estimate rank_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                    const RankIndexOptions& o)
{
    const auto varies = [](const Eigen::VectorXd& v) { return v.maxCoeff() > v.minCoeff(); };
    if (x.size() != y.size() || y.size() < 10 || !x.allFinite() || !y.allFinite())
        throw std::invalid_argument(
            "rank index: x and y must be finite, of equal length, at least 10");
    if (!varies(x) || !varies(y)) throw std::invalid_argument("rank index: x and y must vary");
    if (o.halves < 20 || !(o.confidence > 0.0 && o.confidence < 1.0))
        throw std::invalid_argument("rank index: at least 20 halves, confidence in (0, 1)");
    const auto n = static_cast<std::size_t>(y.size());
    std::vector<Eigen::Index> rows(n);
    std::iota(rows.begin(), rows.end(), 0);
    Stream draw(o.seed, o.stream, Purpose::bootstrap);
    std::vector<double> of_halves;
    for (int b = 0; b < o.halves; ++b) {
        for (std::size_t i = 0; i < n / 2; ++i) std::swap(rows[i], rows[i + draw.below(n - i)]);
        std::vector<Eigen::Index> half(rows.begin(),
                                       rows.begin() + static_cast<std::ptrdiff_t>(n / 2));
        std::ranges::sort(half);
        of_halves.push_back(raw_rank_index(x(half), y(half)));
    }
    const double value = raw_rank_index(x, y);
    // (1 / m) (1 - m / n) of a half, m = n / 2, is the 1 / n of all samples
    const double error = core::moments(of_halves).sd;
    const double reach = error * core::upper_normal_quantile(0.5 * (1.0 - o.confidence));
    return {.value = value,
            .std_error = error,
            .n = n,
            .interval = {std::clamp(value - reach, 0.0, 1.0),
                         std::clamp(value + reach, 0.0, 1.0), o.confidence}};
}

} // namespace uq
