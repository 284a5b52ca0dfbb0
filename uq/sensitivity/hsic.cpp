#include "uq/sensitivity/hsic.hpp"

#include "uq/designs/stream.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace uq {

namespace {

/// H K H, H = 1 - 1/n.
Eigen::MatrixXd centred_kernel(const Eigen::VectorXd& v)
{
    const double square = (v.array() - v.mean()).square().mean();
    if (!(square > 0.0)) throw std::invalid_argument("hsic: x and y must vary");
    const Eigen::Index n = v.size();
    Eigen::MatrixXd k(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            k(i, j) = std::exp(-0.5 * (v(i) - v(j)) * (v(i) - v(j)) / square);
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

} // namespace

Hsic hsic(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const HsicOptions& o)
{
    if (x.size() != y.size() || y.size() < 5 || !x.allFinite() || !y.allFinite())
        throw std::invalid_argument(
            "hsic: x and y must be finite, of equal length, at least 5");
    if (o.permutations < 19) throw std::invalid_argument("hsic: at least 19 permutations");
    const Eigen::MatrixXd a = centred_kernel(x), b = centred_kernel(y);
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
    return {seen / (a.norm() * b.norm()), (1.0 + as_good) / (1.0 + o.permutations)};
}

} // namespace uq
