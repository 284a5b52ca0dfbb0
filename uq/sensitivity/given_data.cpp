#include "uq/sensitivity/given_data.hpp"

#include "uq/estimates/estimate_critical.hpp"
#include "uq/sensitivity/correlation_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// Responses in the order of an input.
Eigen::ArrayXd in_order_of(const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    std::vector<Eigen::Index> order(static_cast<std::size_t>(x.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&x](Eigen::Index a, Eigen::Index b) { return x[a] < x[b]; });
    return y(order);
}

Eigen::ArrayXd next(const Eigen::ArrayXd& v, Eigen::Index by)
{
    Eigen::ArrayXd shifted(v.size());
    shifted << v.tail(v.size() - by), v.head(by);
    return shifted;
}

/// Terms t_k depend on y_k and y_k+1, and their level on x: the covariance of t_k and t_k+1
/// less that of t_k and t_k+2 is what neighbours share through y alone.
double variance_of_sum(const Eigen::ArrayXd& t)
{
    const double own = t.square().sum();
    const double shared = (t * next(t, 1)).sum() - (t * next(t, 2)).sum();
    return std::max(own + 2.0 * shared, 0.1 * own); // the difference is noisy
}

Estimate first_order(const Eigen::ArrayXd& y, std::size_t failed, double confidence)
{
    const auto n = static_cast<double>(y.size());
    const double variance = y.square().mean(); // y has mean 0
    const Eigen::ArrayXd product = y * next(y, 1);
    const double value = product.mean() / variance;
    const Eigen::ArrayXd moved = (product - value * y.square()) / variance;
    const double error = std::sqrt(variance_of_sum(moved)) / n;
    const double half = normal_factor(confidence) * error;
    return {value,
            error,
            static_cast<std::size_t>(y.size()),
            failed,
            {value - half, value + half, confidence}};
}

} // namespace

std::vector<std::optional<Estimate>>
given_data_first_order(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, double confidence)
{
    check_confidence(confidence);
    const SoundRows rows = sound_rows(x, y);
    if (rows.y.size() < 10)
        throw std::invalid_argument(
            "indices from given data need at least 10 sound samples, got " +
            std::to_string(rows.y.size()));
    if (rows.y.maxCoeff() == rows.y.minCoeff())
        throw std::invalid_argument("the response does not vary");
    const Eigen::VectorXd centred = rows.y.array() - rows.y.mean();
    std::vector<std::optional<Estimate>> indices;
    for (const auto input : rows.x.colwise()) {
        if (input.maxCoeff() == input.minCoeff())
            indices.emplace_back();
        else
            indices.emplace_back(
                first_order(in_order_of(input, centred), rows.failed, confidence));
    }
    return indices;
}

} // namespace uq
