#include "uq/estimates/latin_error.hpp"

#include "core/matrix_factors.hpp"
#include "core/normal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace uq {
namespace {

/// Ranks of a column as shares in (0, 1); equal values share the middle of their ranks.
Eigen::VectorXd rank_shares(const Eigen::VectorXd& values)
{
    const auto n = static_cast<std::size_t>(values.size());
    std::vector<Eigen::Index> order(n);
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return values[i]; });
    Eigen::VectorXd shares(values.size());
    for (std::size_t i = 0; i < n;) {
        std::size_t j = i;
        while (j < n && values[order[j]] == values[order[i]]) ++j;
        const double rank = 0.5 * static_cast<double>(i + j) / static_cast<double>(n);
        for (; i < j; ++i) shares[order[i]] = rank;
    }
    return shares;
}

/// Functions of one input: polynomials for what is smooth, waves for what is a step.
enum class Basis { normal_scores, waves };

double basis_function(Basis kind, double share, int degree)
{
    if (kind == Basis::waves) return std::cos(degree * std::numbers::pi * share);
    const double z = core::normal_quantile(share);
    return degree == 1 ? z : z * z - 1.0;
}

/// Mean squares of the residual of an additive fit, over 1 - h and over (1 - h)^2 with h the
/// leverage: without bias where the residual is as large everywhere, and of samples left out.
/// A residual that grows to the ends of an input, as an interaction leaves it, is largest where
/// the fit follows it most.
struct ResidualSquares {
    double unbiased, left_out;
};

ResidualSquares residual_squares(const Eigen::VectorXd& y, const Eigen::MatrixXd& shares,
                                 Basis kind)
{
    constexpr double kLeastRoom = 1e-9; // a sample that the fit follows blindly
    const int degree = latin_degree(shares.rows(), shares.cols());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(shares.rows(), 1 + degree * shares.cols());
    for (Eigen::Index c = 1; c < columns.cols(); ++c)
        for (Eigen::Index i = 0; i < columns.rows(); ++i)
            columns(i, c) = basis_function(kind, shares(i, (c - 1) / degree),
                                           1 + static_cast<int>((c - 1) % degree));
    const Eigen::VectorXd fitted = columns * core::least_squares(columns, y).coefficients;
    const Eigen::ArrayXd room = (1.0 - core::leverages(columns).array()).max(kLeastRoom);
    const Eigen::ArrayXd square = (y - fitted).array().square();
    return {(square / room).mean(), (square / room.square()).mean()};
}

} // namespace

int latin_degree(Eigen::Index samples, Eigen::Index inputs)
{
    if (samples >= 4 * (2 * inputs + 1)) return 2;
    return samples >= 4 * (inputs + 1) ? 1 : 0;
}

double latin_mean_error(std::span<const double> y, const Eigen::MatrixXd& inputs)
{
    const auto n = static_cast<Eigen::Index>(y.size());
    if (n < 2 || inputs.rows() != n)
        throw std::invalid_argument(
            "error under a Latin hypercube: two samples or more, each with its inputs");
    const Eigen::Map<const Eigen::VectorXd> values(y.data(), n);
    if (!values.allFinite() || !inputs.allFinite())
        throw std::invalid_argument("error under a Latin hypercube: a value is not finite");
    Eigen::MatrixXd shares(inputs.rows(), inputs.cols());
    for (Eigen::Index k = 0; k < inputs.cols(); ++k) shares.col(k) = rank_shares(inputs.col(k));
    const ResidualSquares scores = residual_squares(values, shares, Basis::normal_scores),
                          waves = residual_squares(values, shares, Basis::waves);
    const double variance = scores.left_out < waves.left_out ? scores.unbiased : waves.unbiased;
    return std::sqrt(variance / static_cast<double>(n));
}

double latin_subset_error(std::span<const double> y, const std::vector<bool>& member,
                          const Eigen::MatrixXd& inputs)
{
    if (member.size() != y.size())
        throw std::invalid_argument("error under a Latin hypercube: one mark for each sample");
    double n = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!member[i]) continue;
        n += 1.0;
        mean += (y[i] - mean) / n;
    }
    if (n < 2.0)
        throw std::invalid_argument("error under a Latin hypercube: fewer than two members");
    const double share = n / static_cast<double>(y.size());
    std::vector<double> terms(y.size(), 0.0);
    for (std::size_t i = 0; i < y.size(); ++i)
        if (member[i]) terms[i] = (y[i] - mean) / share;
    return latin_mean_error(terms, inputs);
}

} // namespace uq
