#include "fragility/stripe_fit.hpp"

#include "fragility/maximise.hpp"
#include "fragility/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fragility {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct LogTails {
    LogTerm below, above;
};

LogTails log_tails(Link link, double eta)
{
    if (link == Link::logit)
        return {StandardLogistic::log_cdf(eta), StandardLogistic::log_survival(eta)};
    return {StandardNormal::log_cdf(eta), StandardNormal::log_survival(eta)};
}

/// About the mean of ln x, so that the two coefficients hardly depend on each other.
struct Centred {
    std::vector<double> t, exceeded, stood;
    double middle = 0.0;
};

Centred centred(std::span<const Stripe> data)
{
    Centred c;
    double n = 0.0;
    for (const Stripe& s : data) {
        c.middle += s.n * std::log(s.intensity);
        n += s.n;
    }
    c.middle /= n;
    for (const Stripe& s : data) {
        c.t.push_back(std::log(s.intensity) - c.middle);
        c.exceeded.push_back(s.exceeded);
        c.stood.push_back(s.n - s.exceeded);
    }
    return c;
}

Local likelihood(const Centred& c, Link link, const Eigen::VectorXd& b)
{
    Local l{0.0, Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 2)};
    for (std::size_t i = 0; i < c.t.size(); ++i) {
        const LogTails tails = log_tails(link, b[0] + b[1] * c.t[i]);
        const Vector2d x(1.0, c.t[i]);
        l.value += c.exceeded[i] * tails.below.value + c.stood[i] * tails.above.value;
        l.gradient += (c.exceeded[i] * tails.below.d1 + c.stood[i] * tails.above.d1) * x;
        l.hessian +=
            (c.exceeded[i] * tails.below.d2 + c.stood[i] * tails.above.d2) * x * x.transpose();
    }
    return l;
}

/// Sum of n f^2 / (F (1 - F)) x x'; f / F and f / (1 - F) are the slopes of the log tails.
Matrix2d expected_information(const Centred& c, Link link, const Eigen::VectorXd& b)
{
    Matrix2d sum = Matrix2d::Zero();
    for (std::size_t i = 0; i < c.t.size(); ++i) {
        const LogTails tails = log_tails(link, b[0] + b[1] * c.t[i]);
        const Vector2d x(1.0, c.t[i]);
        sum +=
            -(c.exceeded[i] + c.stood[i]) * tails.below.d1 * tails.above.d1 * x * x.transpose();
    }
    return sum;
}

std::optional<std::pair<ModelOutcome, std::string>> screen(std::span<const Stripe> data)
{
    using enum ModelOutcome;
    if (data.empty()) return std::pair{no_data, std::string("no data")};
    double highest_stood = -1.0;
    double lowest_exceeded = HUGE_VAL;
    double least = HUGE_VAL;
    double most = 0.0;
    for (std::size_t i = 0; i < data.size(); ++i) {
        const Stripe& s = data[i];
        if (!(s.intensity > 0.0 && std::isfinite(s.intensity) && s.n > 0.0 &&
              std::isfinite(s.n) && s.exceeded >= 0.0 && s.exceeded <= s.n))
            return std::pair{invalid_value,
                             "stripe " + std::to_string(i + 1) +
                                 ": needs intensity > 0 and 0 <= exceeded <= n, n > 0"};
        if (s.exceeded > 0.0) lowest_exceeded = std::min(lowest_exceeded, s.intensity);
        if (s.exceeded < s.n) highest_stood = std::max(highest_stood, s.intensity);
        least = std::min(least, s.intensity);
        most = std::max(most, s.intensity);
    }
    if (lowest_exceeded == HUGE_VAL || highest_stood < 0.0)
        return std::pair{no_contrast,
                         std::string(highest_stood < 0.0 ? "all exceeded" : "none exceeded")};
    if (least == most) return std::pair{no_contrast, std::string("only one intensity")};
    if (highest_stood <= lowest_exceeded)
        return std::pair{separated, "separated: the median lies between " +
                                        std::to_string(highest_stood) + " and " +
                                        std::to_string(lowest_exceeded) +
                                        ", the dispersion cannot be told from zero"};
    return std::nullopt;
}

void add_constants(StripeFit& f, std::span<const Stripe> data)
{
    double saturated = 0.0;
    double constants = 0.0;
    for (const Stripe& s : data) {
        const double stood = s.n - s.exceeded;
        if (s.exceeded > 0.0) saturated += s.exceeded * std::log(s.exceeded / s.n);
        if (stood > 0.0) saturated += stood * std::log(stood / s.n);
        constants +=
            std::lgamma(s.n + 1.0) - std::lgamma(s.exceeded + 1.0) - std::lgamma(stood + 1.0);
    }
    f.deviance = 2.0 * (saturated - f.log_likelihood);
    f.log_likelihood += constants;
}

} // namespace

StripeFit fit_stripes(std::span<const Stripe> data, Link link)
{
    StripeFit f;
    f.link = link;
    if (const auto no = screen(data)) {
        f.outcome = no->first;
        f.reason = no->second;
        return f;
    }
    const Centred c = centred(data);
    const Maximum m = maximise([&](const Eigen::VectorXd& b) { return likelihood(c, link, b); },
                               Vector2d::Zero());
    if (!m.converged) {
        f.outcome = ModelOutcome::not_converged;
        f.reason = "not converged after " + std::to_string(m.iterations) + " iterations";
        return f;
    }
    if (!(m.at[1] > 0.0)) {
        f.outcome = ModelOutcome::wrong_slope;
        f.reason = "exceedance does not grow with intensity";
        return f;
    }
    f.outcome = ModelOutcome::converged;
    f.b1 = m.at[1];
    f.b0 = m.at[0] - m.at[1] * c.middle;
    f.median = std::exp(c.middle - m.at[0] / m.at[1]);
    f.dispersion = 1.0 / m.at[1];
    Matrix2d d; // of (ln median, dispersion) for the coefficients about the middle
    d << -f.dispersion, m.at[0] * f.dispersion * f.dispersion, 0.0,
        -f.dispersion * f.dispersion;
    f.expected = d * expected_information(c, link, m.at).inverse() * d.transpose();
    f.observed = d * (-m.local.hessian).inverse() * d.transpose();
    f.log_likelihood = m.local.value;
    add_constants(f, data);
    return f;
}

/// Gauss-Newton: the curvature of the residuals is left out, which keeps it downhill.
std::optional<LeastSquaresCurve> fit_least_squares(std::span<const Stripe> data, Link link)
{
    const StripeFit start = fit_stripes(data, link);
    if (start.outcome != ModelOutcome::converged) return std::nullopt;
    const Centred c = centred(data);
    const auto f = [&](const Eigen::VectorXd& b) {
        Local l{0.0, Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 2)};
        for (std::size_t i = 0; i < c.t.size(); ++i) {
            const LogTails tails = log_tails(link, b[0] + b[1] * c.t[i]);
            const double p = std::exp(tails.below.value);
            const double miss = c.exceeded[i] / (c.exceeded[i] + c.stood[i]) - p;
            const Vector2d slope = p * tails.below.d1 * Vector2d(1.0, c.t[i]);
            l.value -= 0.5 * miss * miss;
            l.gradient += miss * slope;
            l.hessian -= slope * slope.transpose();
        }
        return l;
    };
    const Maximum m = maximise(f, Vector2d(start.b0 + start.b1 * c.middle, start.b1));
    if (!m.converged || !(m.at[1] > 0.0)) return std::nullopt;
    return LeastSquaresCurve{std::exp(c.middle - m.at[0] / m.at[1]), 1.0 / m.at[1],
                             -2.0 * m.local.value};
}

} // namespace fragility
