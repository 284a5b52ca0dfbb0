#include "uq/sensitivity/hsic.hpp"

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

Eigen::MatrixXd kernel_of(const Eigen::VectorXd& v)
{
    const double square = (v.array() - v.mean()).square().mean();
    if (!(square > 0.0)) throw std::invalid_argument("hsic: x and y must vary");
    const Eigen::Index n = v.size();
    Eigen::MatrixXd k(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            k(i, j) = std::exp(-0.5 * (v(i) - v(j)) * (v(i) - v(j)) / square);
    return k;
}

/// H K H, H = 1 - 1/n.
Eigen::MatrixXd centred(Eigen::MatrixXd k)
{
    const Eigen::RowVectorXd means = k.colwise().mean();
    const double mean = means.mean();
    k.rowwise() -= means;
    k.colwise() -= means.transpose();
    k.array() += mean;
    return k;
}

double paired(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
              const std::vector<Eigen::Index>& order)
{
    double sum = 0.0;
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
        const Eigen::Index to = order[static_cast<std::size_t>(j)];
        for (Eigen::Index i = 0; i < j; ++i)
            sum += 2.0 * a(i, j) * b(order[static_cast<std::size_t>(i)], to);
        sum += a(j, j) * b(to, to);
    }
    return sum;
}

/// Sums over pairs of different samples, from which HSIC without bias follows (Song et al.
/// 2012, eq. 5).
struct PairSums {
    double n = 0.0;
    double both = 0.0; ///< sum of k l
    double all_k = 0.0, all_l = 0.0;
    double rows = 0.0; ///< sum over samples of (sum of k) (sum of l)

    [[nodiscard]] double unbiased() const
    {
        return (both + all_k * all_l / ((n - 1.0) * (n - 2.0)) - 2.0 * rows / (n - 2.0)) /
               (n * (n - 3.0));
    }
};

/// HSIC of all samples, and without each of them in turn. @param k, l diagonals are 0
struct LeftOut {
    double all;
    Eigen::VectorXd without;
};
LeftOut unbiased_hsic(const Eigen::MatrixXd& k, const Eigen::MatrixXd& l)
{
    const Eigen::VectorXd a = k.colwise().sum(), b = l.colwise().sum();
    const Eigen::MatrixXd product = k.cwiseProduct(l);
    const Eigen::VectorXd own = product.colwise().sum();
    const PairSums s{static_cast<double>(a.size()), own.sum(), a.sum(), b.sum(), a.dot(b)};
    LeftOut h{s.unbiased(), Eigen::VectorXd(a.size())};
    for (Eigen::Index i = 0; i < a.size(); ++i) {
        PairSums t = s;
        t.n -= 1.0;
        t.both -= 2.0 * own(i);
        t.all_k -= 2.0 * a(i);
        t.all_l -= 2.0 * b(i);
        t.rows += own(i) - a(i) * b(i) - k.col(i).dot(b) - l.col(i).dot(a);
        h.without(i) = t.unbiased();
    }
    return h;
}

double share_of(double xy, double xx, double yy)
{
    return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

Estimate unbiased_index(Eigen::MatrixXd k, Eigen::MatrixXd l, double confidence)
{
    k.diagonal().setZero();
    l.diagonal().setZero();
    const LeftOut xy = unbiased_hsic(k, l), xx = unbiased_hsic(k, k), yy = unbiased_hsic(l, l);
    std::vector<double> without;
    for (Eigen::Index i = 0; i < k.rows(); ++i)
        without.push_back(share_of(xy.without(i), xx.without(i), yy.without(i)));
    const auto n = static_cast<double>(k.rows());
    const double value = share_of(xy.all, xx.all, yy.all);
    const double error = core::moments(without).sd * (n - 1.0) / std::sqrt(n);
    const double half = error * core::upper_normal_quantile(0.5 * (1.0 - confidence));
    return {.value = value,
            .std_error = error,
            .n = without.size(),
            .interval = {std::clamp(value - half, 0.0, 1.0), std::clamp(value + half, 0.0, 1.0),
                         confidence}};
}

} // namespace

Hsic hsic(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const HsicOptions& o)
{
    if (x.size() != y.size() || y.size() < 6 || !x.allFinite() || !y.allFinite())
        throw std::invalid_argument(
            "hsic: x and y must be finite, of equal length, at least 6");
    if (o.permutations < 19 || !(o.confidence > 0.0 && o.confidence < 1.0))
        throw std::invalid_argument("hsic: at least 19 permutations, confidence in (0, 1)");
    const Eigen::MatrixXd k = kernel_of(x), l = kernel_of(y);
    const Eigen::MatrixXd a = centred(k), b = centred(l);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(y.size()));
    std::iota(order.begin(), order.end(), 0);
    const double seen = paired(a, b, order);
    Stream draw(o.seed, o.stream, Purpose::bootstrap);
    int as_good = 0;
    for (int p = 0; p < o.permutations; ++p) {
        for (std::size_t i = order.size() - 1; i > 0; --i)
            std::swap(order[i], order[draw.below(i + 1)]);
        as_good += paired(a, b, order) >= seen ? 1 : 0;
    }
    return {std::clamp(seen / (a.norm() * b.norm()), 0.0, 1.0),
            unbiased_index(k, l, o.confidence), (1.0 + as_good) / (1.0 + o.permutations)};
}

} // namespace uq
