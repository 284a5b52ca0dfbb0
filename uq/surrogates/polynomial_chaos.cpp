#include "uq/surrogates/polynomial_chaos.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace uq {

namespace {

constexpr double kOnBorder = 1e-9; // degrees on the border of the set belong to it

void grow_set(std::vector<std::vector<int>>& set, std::vector<int>& alpha, std::size_t k,
              double left, double q, int degree)
{
    if (k == alpha.size()) {
        set.push_back(alpha);
        return;
    }
    for (int a = 0; a <= degree && std::pow(a, q) <= left + kOnBorder; ++a) {
        alpha[k] = a;
        grow_set(set, alpha, k + 1, left - std::pow(a, q), q, degree);
    }
    alpha[k] = 0;
}

} // namespace

Eigen::MatrixXi hyperbolic_set(int inputs, int degree, double q)
{
    std::vector<std::vector<int>> set;
    std::vector<int> alpha(static_cast<std::size_t>(inputs), 0);
    grow_set(set, alpha, 0, std::pow(degree, q), q, degree);
    const auto total = [](const std::vector<int>& a) {
        int sum = 0;
        for (const int x : a) sum += x;
        return sum;
    };
    std::ranges::stable_sort(set, {}, total);
    Eigen::MatrixXi degrees(static_cast<Eigen::Index>(set.size()), inputs);
    for (std::size_t t = 0; t < set.size(); ++t)
        for (int k = 0; k < inputs; ++k)
            degrees(static_cast<Eigen::Index>(t), k) = set[t][static_cast<std::size_t>(k)];
    return degrees;
}

Eigen::MatrixXd chaos_terms(const std::vector<PolynomialFamily>& families,
                            const Eigen::MatrixXi& degrees, const Eigen::MatrixXd& c)
{
    if (c.cols() != static_cast<Eigen::Index>(families.size()) || degrees.cols() != c.cols())
        throw std::invalid_argument("chaos: one coordinate for each input");
    Eigen::MatrixXd terms = Eigen::MatrixXd::Ones(c.rows(), degrees.rows());
    for (Eigen::Index k = 0; k < c.cols(); ++k) {
        const int most = degrees.rows() > 0 ? degrees.col(k).maxCoeff() : 0;
        if (most == 0) continue;
        Eigen::MatrixXd values(c.rows(), most + 1);
        for (Eigen::Index i = 0; i < c.rows(); ++i)
            values.row(i) =
                polynomials(families[static_cast<std::size_t>(k)], most, c(i, k)).transpose();
        for (Eigen::Index t = 0; t < degrees.rows(); ++t)
            if (degrees(t, k) > 0) terms.col(t).array() *= values.col(degrees(t, k)).array();
    }
    return terms;
}

Eigen::VectorXd predict(const PolynomialChaos& chaos, const Eigen::MatrixXd& c)
{
    constexpr Eigen::Index kRows = 1024; // of a block: all its terms stay in the cache
    Eigen::VectorXd y = Eigen::VectorXd::Zero(c.rows());
    for (Eigen::Index from = 0; from < c.rows(); from += kRows) {
        const Eigen::Index n = std::min(kRows, c.rows() - from);
        const Eigen::MatrixXd terms =
            chaos_terms(chaos.families, chaos.degrees, c.middleRows(from, n));
        for (Eigen::Index t = 0; t < terms.cols();
             ++t) // each row alone, in the order of the terms
            y.segment(from, n) += chaos.coefficients(t) * terms.col(t);
    }
    return y;
}

double mean(const PolynomialChaos& chaos)
{
    double sum = 0.0;
    for (Eigen::Index t = 0; t < chaos.degrees.rows(); ++t)
        if ((chaos.degrees.row(t).array() == 0).all()) sum += chaos.coefficients(t);
    return sum;
}

double variance(const PolynomialChaos& chaos)
{
    double sum = 0.0;
    for (Eigen::Index t = 0; t < chaos.degrees.rows(); ++t)
        if ((chaos.degrees.row(t).array() > 0).any())
            sum += chaos.coefficients(t) * chaos.coefficients(t);
    return sum;
}

ChaosIndices sobol_indices(const PolynomialChaos& chaos)
{
    const Eigen::Index d = chaos.degrees.cols();
    ChaosIndices s{Eigen::VectorXd::Zero(d), Eigen::VectorXd::Zero(d)};
    const double all = variance(chaos);
    if (!(all > 0.0)) return s;
    for (Eigen::Index t = 0; t < chaos.degrees.rows(); ++t) {
        const double share = chaos.coefficients(t) * chaos.coefficients(t) / all;
        const auto active = (chaos.degrees.row(t).array() > 0).count();
        for (Eigen::Index k = 0; k < d; ++k) {
            if (chaos.degrees(t, k) == 0) continue;
            s.total(k) += share;
            if (active == 1) s.first(k) += share;
        }
    }
    s.first = s.first.cwiseMin(1.0);
    s.total = s.total.cwiseMin(1.0);
    return s;
}

} // namespace uq
