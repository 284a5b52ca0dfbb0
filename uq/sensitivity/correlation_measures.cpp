#include "uq/sensitivity/correlation_measures.hpp"

#include "core/critical.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace uq {

namespace {

/// Nothing if one of them does not vary.
std::optional<double> correlation(const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    if (x.maxCoeff() == x.minCoeff() || y.maxCoeff() == y.minCoeff()) return {};
    const Eigen::VectorXd a = x.array() - x.mean(), b = y.array() - y.mean();
    return std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0);
}

/// `extra`: what the variance of z grows by with r^2.
std::optional<Estimate> with_interval(const SoundRows& rows, const Eigen::VectorXd& x,
                                      const Eigen::VectorXd& y, double extra, double confidence)
{
    core::check_confidence(confidence);
    if (rows.y.size() < 4)
        throw std::invalid_argument("a correlation needs at least 4 sound samples, got " +
                                    std::to_string(rows.y.size()));
    const std::optional<double> r = correlation(x, y);
    if (!r) return {};
    const auto n = static_cast<double>(rows.y.size());
    const double z_error = std::sqrt((1.0 + extra * *r * *r) / (n - 3.0));
    return Estimate{*r, (1.0 - *r * *r) * z_error, static_cast<std::size_t>(rows.y.size()),
                    rows.failed, fisher_interval(*r, z_error, confidence)};
}

} // namespace

SoundRows sound_rows(const Eigen::MatrixXd& x, const Eigen::VectorXd& y)
{
    if (x.rows() != y.size())
        throw std::invalid_argument("inputs have " + std::to_string(x.rows()) +
                                    " rows, the response " + std::to_string(y.size()));
    if (x.array().isInf().any() || y.array().isInf().any())
        throw std::invalid_argument("an input or response is infinite");
    std::vector<Eigen::Index> sound;
    for (Eigen::Index i = 0; i < y.size(); ++i)
        if (!std::isnan(y[i]) && !x.row(i).hasNaN()) sound.push_back(i);
    return {x(sound, Eigen::all), y(sound), static_cast<std::size_t>(y.size()) - sound.size()};
}

Eigen::VectorXd ranks(const Eigen::VectorXd& y)
{
    std::vector<Eigen::Index> order(static_cast<std::size_t>(y.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&y](Eigen::Index a, Eigen::Index b) { return y[a] < y[b]; });
    Eigen::VectorXd r(y.size());
    for (std::size_t i = 0; i < order.size();) {
        std::size_t end = i + 1;
        while (end < order.size() && y[order[end]] == y[order[i]]) ++end;
        for (std::size_t k = i; k < end; ++k)
            r[order[k]] = 0.5 * static_cast<double>(i + 1 + end);
        i = end;
    }
    return r;
}

core::Interval fisher_interval(double r, double z_error, double confidence)
{
    if (std::abs(r) >= 1.0) return {r, r, confidence};
    const double z = std::atanh(r), half = core::normal_factor(confidence) * z_error;
    return {std::tanh(z - half), std::tanh(z + half), confidence};
}

std::optional<Estimate> pearson(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                double confidence)
{
    const SoundRows rows = sound_rows(x, y);
    return with_interval(rows, rows.x.col(0), rows.y, 0.0, confidence);
}

std::optional<Estimate> spearman(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                 double confidence)
{
    const SoundRows rows = sound_rows(x, y);
    return with_interval(rows, ranks(rows.x.col(0)), ranks(rows.y), kRankVariance, confidence);
}

} // namespace uq
