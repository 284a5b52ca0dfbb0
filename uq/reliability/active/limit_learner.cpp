#include "uq/reliability/active/limit_learner.hpp"

#include "uq/surrogates/process_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace uq {
namespace {

/// Scales of compression, over the median of |g|; infinite: none. Tuned.
constexpr std::array kCompressions = {std::numeric_limits<double>::infinity(), 1.0, 0.25};
constexpr Eigen::Index kMostKnown = 600, kMostFitted = 200;
constexpr Eigen::Index kLeastKnown = 3;

/// @param scale infinite: g as it is
Eigen::VectorXd compressed(const Eigen::VectorXd& g, double scale)
{
    return std::isinf(scale) ? g : Eigen::VectorXd((g / scale).array().asinh());
}

/// Log likelihood of g itself.
double likelihood(const GaussianProcess& p, const Eigen::VectorXd& g, double scale)
{
    if (std::isinf(scale)) return p.log_likelihood;
    return p.log_likelihood - 0.5 * (g.array().square() + scale * scale).log().sum();
}

} // namespace

bool Learner::full() const { return g_.size() >= kMostKnown; }

void Learner::learn(const Eigen::MatrixXd& u, const Eigen::VectorXd& g)
{
    passed_ = passed_ || (g.array() <= 0.0).any(); // NaN is not
    Eigen::Index n = g_.size();
    u_.conservativeResize(n + g.size(), u.cols());
    g_.conservativeResize(n + g.size());
    for (Eigen::Index i = 0; i < g.size(); ++i) {
        if (std::isnan(g(i)) || n >= kMostKnown) continue;
        u_.row(n) = u.row(i);
        g_(n++) = g(i);
    }
    u_.conservativeResize(n, u.cols());
    g_.conservativeResize(n);
}

const GaussianProcess& Learner::process(double shift)
{
    const Eigen::Index n = g_.size();
    if (n < kLeastKnown) throw std::invalid_argument("fewer than three evaluations answered");
    const Eigen::VectorXd g = g_.array() - shift;
    if (!last_ || (7 * n > 8 * fitted_ && fitted_ < kMostFitted))
        fit(g);
    else
        last_ = condition({u_, compressed(g, scale_), {}}, last_->kernel, last_->trend,
                          ProcessParameters(last_->parameters));
    return *last_;
}

void Learner::fit(const Eigen::VectorXd& g)
{
    fitted_ = g.size();
    const bool linear = fitted_ >= 2 * (u_.cols() + 1);
    const auto trend = linear ? ProcessTrend::linear : ProcessTrend::constant;
    Eigen::VectorXd size = g.cwiseAbs();
    std::ranges::nth_element(size, size.begin() + size.size() / 2);
    const double middle = size(size.size() / 2);
    last_.reset();
    double most = -std::numeric_limits<double>::infinity();
    for (const double share : kCompressions) {
        const double scale = std::isinf(share) ? share : share * middle;
        if (!(scale > 0.0)) continue;
        GaussianProcess p = fit_process({u_, compressed(g, scale), {}}, {.trend = trend});
        const double now = likelihood(p, g, scale);
        if (last_ && !(now > most)) continue;
        most = now;
        scale_ = scale;
        last_ = std::move(p);
    }
}

} // namespace uq
