#include "uq/inference/chain_diagnostics.hpp"

#include "core/normal.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace uq {
namespace {

/// Each chain as two.
Eigen::MatrixXd split(const Eigen::MatrixXd& draws)
{
    const Eigen::Index half = draws.rows() / 2;
    Eigen::MatrixXd s(half, 2 * draws.cols());
    s << draws.topRows(half), draws.bottomRows(half);
    return s;
}

/// Normal scores of the ranks, (r - 3/8) / (n + 1/4); equal draws share the mean of theirs.
Eigen::MatrixXd normal_scores(const Eigen::MatrixXd& draws)
{
    const auto n = static_cast<std::size_t>(draws.size());
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const double* const y = draws.data();
    std::ranges::sort(order, {}, [y](std::size_t i) { return y[i]; });
    Eigen::MatrixXd scores(draws.rows(), draws.cols());
    for (std::size_t first = 0; first < n;) {
        std::size_t end = first + 1;
        while (end < n && y[order[end]] == y[order[first]]) ++end;
        const double rank = 0.5 * static_cast<double>(first + 1 + end);
        const double score =
            core::normal_quantile((rank - 0.375) / (static_cast<double>(n) + 0.25));
        for (; first < end; ++first) scores.data()[order[first]] = score;
    }
    return scores;
}

struct Variances {
    double within, pooled;
};

Variances variances(const Eigen::MatrixXd& y)
{
    const auto n = static_cast<double>(y.rows()), m = static_cast<double>(y.cols());
    const Eigen::RowVectorXd mean = y.colwise().mean();
    const double within = (y.rowwise() - mean).colwise().squaredNorm().sum() / (m * (n - 1.0));
    const double between = (mean.array() - mean.mean()).square().sum() / (m - 1.0);
    return {within, (n - 1.0) / n * within + between};
}

/// Mean over the chains of the autocovariance at a lag, over n.
double autocovariance(const Eigen::MatrixXd& centred, Eigen::Index lag)
{
    const Eigen::Index n = centred.rows() - lag;
    return (centred.topRows(n).array() * centred.bottomRows(n).array()).sum() /
           static_cast<double>(centred.size());
}

double effective_size(const Eigen::MatrixXd& y)
{
    const Variances v = variances(y);
    const auto all = static_cast<double>(y.size());
    if (!(v.pooled > 0.0)) return all;
    const Eigen::MatrixXd centred = y.rowwise() - y.colwise().mean();
    const auto n = static_cast<double>(y.rows());
    const auto correlation = [&](Eigen::Index lag) {
        return 1.0 - (v.within - n / (n - 1.0) * autocovariance(centred, lag)) / v.pooled;
    };
    double sum = 0.0, least = 1.0 + correlation(1);
    for (Eigen::Index lag = 0; lag + 1 < y.rows(); lag += 2) {
        const double pair = (lag == 0 ? 1.0 : correlation(lag)) + correlation(lag + 1);
        if (!(pair > 0.0)) break;
        least = std::min(least, pair);
        sum += least;
    }
    const double time = std::max(2.0 * sum - 1.0, 1.0 / std::log10(all));
    return all / time;
}

} // namespace

ChainDiagnostics diagnose(const Eigen::MatrixXd& draws)
{
    if (draws.rows() < 8 || draws.cols() < 1)
        throw std::invalid_argument("chain diagnostics: at least 8 draws of a chain");
    const Eigen::MatrixXd scores = normal_scores(split(draws));
    const Variances v = variances(scores);
    return {v.within > 0.0 ? std::sqrt(v.pooled / v.within) : 1.0, effective_size(scores)};
}

} // namespace uq
