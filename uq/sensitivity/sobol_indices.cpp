#include "uq/sensitivity/sobol_indices.hpp"

#include "core/critical.hpp"
#include "core/moments.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// Responses of the rows that are sound for one index, less the common mean.
struct Rows {
    Eigen::ArrayXd a, b, ab;
    Eigen::ArrayXd variance; ///< each row's part in the variance
    std::size_t failed;
};

Rows rows_of(const Eigen::VectorXd& y, Eigen::Index n, Eigen::Index input)
{
    std::vector<Eigen::Index> sound;
    for (Eigen::Index k = 0; k < n; ++k)
        if (!std::isnan(y[k]) && !std::isnan(y[n + k]) && !std::isnan(y[(2 + input) * n + k]))
            sound.push_back(k);
    if (sound.size() < 2)
        throw std::invalid_argument("index of input " + std::to_string(input) +
                                    ": at least 2 sound rows are needed, got " +
                                    std::to_string(sound.size()));
    Rows r{y.segment(0, n)(sound),
           y.segment(n, n)(sound),
           y.segment((2 + input) * n, n)(sound),
           {},
           static_cast<std::size_t>(n) - sound.size()};
    const double mean = 0.5 * (r.a.mean() + r.b.mean());
    r.a -= mean; // the estimators are the same for y plus a constant, their errors are not
    r.b -= mean;
    r.ab -= mean;
    r.variance = 0.5 * (r.a.square() + r.b.square());
    return r;
}

/// Mean of `part` over the mean of the variance.
Estimate ratio(const Eigen::ArrayXd& part, const Rows& r, double confidence)
{
    const auto n = static_cast<double>(part.size());
    const double variance = r.variance.mean();
    if (!(variance > 0.0)) throw std::invalid_argument("the response does not vary");
    const double value = part.mean() / variance;
    const Eigen::ArrayXd moved = (part - value * r.variance) / variance; // mean 0
    const double error = std::sqrt(moved.square().sum() / (n * (n - 1.0)));
    const double half = core::normal_factor(confidence) * error;
    return {value,
            error,
            static_cast<std::size_t>(part.size()),
            r.failed,
            {value - half, value + half, confidence}};
}

/// Variance of the sound responses to A and B: the same for every index.
double variance_of(const Eigen::VectorXd& y, Eigen::Index n)
{
    std::vector<double> sound;
    for (Eigen::Index k = 0; k < 2 * n; ++k)
        if (!std::isnan(y[k])) sound.push_back(y[k]);
    const double sd = core::moments(sound).sd;
    return sd * sd;
}

} // namespace

Eigen::MatrixXd pick_freeze(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    if (a.rows() != b.rows() || a.cols() != b.cols() || a.size() == 0)
        throw std::invalid_argument("A and B must be of one size, not empty");
    const Eigen::Index n = a.rows(), d = a.cols();
    Eigen::MatrixXd x(n * (d + 2), d);
    x.topRows(n) = a;
    x.middleRows(n, n) = b;
    for (Eigen::Index i = 0; i < d; ++i) {
        x.middleRows((2 + i) * n, n) = a;
        x.middleRows((2 + i) * n, n).col(i) = b.col(i);
    }
    return x;
}

SobolIndices sobol_indices(const Eigen::VectorXd& y, Eigen::Index d, double confidence)
{
    core::check_confidence(confidence);
    if (d < 1 || y.size() == 0 || y.size() % (d + 2) != 0)
        throw std::invalid_argument("got " + std::to_string(y.size()) +
                                    " responses, must be a multiple of " +
                                    std::to_string(d + 2));
    if (y.array().isInf().any()) throw std::invalid_argument("a response is infinite");
    const Eigen::Index n = y.size() / (d + 2);
    SobolIndices s{{}, variance_of(y, n)};
    for (Eigen::Index i = 0; i < d; ++i) {
        const Rows r = rows_of(y, n, i);
        s.inputs.push_back({ratio(r.b * (r.ab - r.a), r, confidence),
                            ratio(0.5 * (r.a - r.ab).square(), r, confidence)});
    }
    return s;
}

} // namespace uq
