#include "uq/reliability/simulation/control_variate.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

void check(const NestedValues& y, double confidence)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("controlled mean: " + what);
    };
    require(!y.empty() && y[0].size() >= 3, "at least 3 expensive values are needed");
    for (std::size_t i = 0; i < y.size(); ++i) {
        require(y[i].allFinite(), "values must be finite");
        require(i == 0 || y[i].size() >= y[i - 1].size(),
                "a cheaper model must have as many values as the one before, or more");
    }
    require(confidence > 0.0 && confidence < 1.0, "confidence must be in (0, 1)");
}

double covariance(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return (a.array() - a.mean()).matrix().dot((b.array() - b.mean()).matrix()) /
           static_cast<double>(a.size() - 1);
}

double coefficient(double common, double own) { return own > 0.0 ? common / own : 0.0; }

/// Values less their means over the n_0 shared samples, which makes it easy to leave one out.
struct Centred {
    Eigen::MatrixXd shared;   ///< n_0 x (1 + cheap), expensive first
    Eigen::VectorXd products; ///< sum of expensive x cheap
    Eigen::VectorXd squares;  ///< sum of cheap^2
    Eigen::VectorXd total;    ///< of each cheap model, over all n_i
    Eigen::VectorXd before;   ///< over the first n_(i-1)
    Eigen::VectorXd size, size_before;
    double expensive_mean;

    explicit Centred(const NestedValues& y)
        : shared(y[0].size(), static_cast<Eigen::Index>(y.size())), expensive_mean(y[0].mean())
    {
        const auto cheap = static_cast<Eigen::Index>(y.size()) - 1;
        shared.col(0) = y[0].array() - expensive_mean;
        total = before = size = size_before = Eigen::VectorXd::Zero(cheap);
        for (Eigen::Index i = 0; i < cheap; ++i) {
            const Eigen::VectorXd& v = y[static_cast<std::size_t>(i) + 1];
            const Eigen::Index first = y[static_cast<std::size_t>(i)].size();
            const Eigen::VectorXd centred = v.array() - v.head(y[0].size()).mean();
            shared.col(i + 1) = centred.head(y[0].size());
            total(i) = centred.sum();
            before(i) = centred.head(first).sum();
            size(i) = static_cast<double>(v.size());
            size_before(i) = static_cast<double>(first);
        }
        products = shared.rightCols(cheap).transpose() * shared.col(0);
        squares = shared.rightCols(cheap).colwise().squaredNorm().transpose();
    }

    [[nodiscard]] Eigen::VectorXd coefficients() const
    {
        Eigen::VectorXd a(products.size());
        for (Eigen::Index i = 0; i < a.size(); ++i) a(i) = coefficient(products(i), squares(i));
        return a;
    }

    [[nodiscard]] double value() const
    {
        const Eigen::ArrayXd shift =
            total.array() / size.array() - before.array() / size_before.array();
        return expensive_mean + coefficients().dot(shift.matrix());
    }

    /// The value without shared sample j: the others stand for the n_0 of them, among as many
    /// further samples as before.
    [[nodiscard]] double value_without(Eigen::Index j) const
    {
        const auto n = static_cast<double>(shared.rows());
        double sum = expensive_mean - shared(j, 0) / (n - 1.0);
        for (Eigen::Index i = 0; i < products.size(); ++i) {
            const double y = shared(j, i + 1), share = n / (n - 1.0);
            const double a =
                coefficient(products(i) - share * shared(j, 0) * y, squares(i) - share * y * y);
            sum += a * ((total(i) - share * y) / size(i) -
                        (before(i) - share * y) / size_before(i));
        }
        return sum;
    }
};

/// Variance from the samples that only model b and the cheaper ones have. Each enters the
/// estimate as a sum over the models, with a weight that differs by model.
double block_variance(const NestedValues& y, const Eigen::VectorXd& a, std::size_t b)
{
    const Eigen::Index first = y[b - 1].size(), n = y[b].size() - first;
    if (n < 2) return 0.0;
    Eigen::VectorXd part = Eigen::VectorXd::Zero(n);
    for (std::size_t i = b; i < y.size(); ++i) {
        double weight = 1.0 / static_cast<double>(y[i].size());
        if (i > b) weight -= 1.0 / static_cast<double>(y[i - 1].size());
        part += a(static_cast<Eigen::Index>(i) - 1) * weight * y[i].segment(first, n);
    }
    return static_cast<double>(n) * covariance(part, part);
}

} // namespace

ControlledMean controlled_mean(const NestedValues& y, double confidence)
{
    check(y, confidence);
    const Centred c(y);
    const Eigen::Index n = y[0].size();
    const auto count = static_cast<double>(n);
    ControlledMean m{{}, c.coefficients(), {}, 0.0};
    const double expensive = c.shared.col(0).squaredNorm();
    m.plain_std_error = std::sqrt(expensive / (count * (count - 1.0)));
    m.correlation = Eigen::VectorXd::Zero(c.products.size());
    for (Eigen::Index i = 0; i < c.products.size(); ++i)
        if (expensive > 0.0 && c.squares(i) > 0.0)
            m.correlation(i) =
                std::clamp(c.products(i) / std::sqrt(expensive * c.squares(i)), -1.0, 1.0);

    Eigen::VectorXd without(n);
    for (Eigen::Index j = 0; j < n; ++j) without(j) = c.value_without(j);
    const double v = count * c.value() - (count - 1.0) * without.mean();
    double variance = (count - 1.0) / count * (without.array() - without.mean()).square().sum();
    for (std::size_t b = 1; b < y.size(); ++b) variance += block_variance(y, m.coefficient, b);
    const double se = std::sqrt(variance);
    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), count - 1.0);
    m.estimate = {v, se, static_cast<std::size_t>(n), 0, {v - t * se, v + t * se, confidence}};
    return m;
}

} // namespace uq
