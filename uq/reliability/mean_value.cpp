#include "uq/reliability/mean_value.hpp"

#include "uq/reliability/evaluate.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace uq {

MeanValue mean_value(const Model& model, Eigen::Index response, const Eigen::VectorXd& mean,
                     const Eigen::VectorXd& sd, const Eigen::MatrixXd& correlation, double step)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("mean value: " + what);
    };
    const Eigen::Index d = mean.size();
    require(d >= 1 && mean.allFinite(), "means must be finite, at least one");
    require(sd.size() == d && (sd.array() > 0.0).all() && sd.allFinite(),
            "one positive standard deviation is needed for each mean");
    require(correlation.rows() == d && correlation.cols() == d && correlation.allFinite(),
            "the correlation matrix must be square and as large as the means");
    require(step > 0.0 && step <= 1.0, "step must be in (0, 1]");
    require(response >= 0, "response must be at least 0");

    Samples s{mean.transpose().replicate(2 * d + 1, 1),
              std::vector<std::uint64_t>(static_cast<std::size_t>(2 * d + 1))};
    std::iota(s.id.begin(), s.id.end(), std::uint64_t{0});
    for (Eigen::Index i = 0; i < d; ++i) {
        s.x(1 + i, i) += step * sd(i);
        s.x(1 + d + i, i) -= step * sd(i);
    }
    const Responses r = evaluate(model, s, response + 1);
    for (const std::string& why : r.failure)
        if (!why.empty()) return {0.0, 0.0, Eigen::MatrixXd::Zero(d, d), why};
    const Eigen::VectorXd y = r.y.col(response);
    const Eigen::VectorXd per_sd = (y.segment(1, d) - y.tail(d)) / (2.0 * step);
    const Eigen::MatrixXd parts = (per_sd * per_sd.transpose()).cwiseProduct(correlation);
    const double variance = std::max(0.0, parts.sum());
    return {y(0),
            std::sqrt(variance),
            variance > 0.0 ? Eigen::MatrixXd(parts / variance) : Eigen::MatrixXd::Zero(d, d),
            {}};
}

} // namespace uq
