#include "fragility/intensity/cloud.hpp"

#include "fragility/intensity/cloud_term.hpp"
#include "fragility/laws/maximise.hpp"
#include "fragility/laws/standard_law.hpp"

#include <cmath>

namespace fragility {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct CloudRow {
    double x, y, weight; ///< ln intensity about its mean, ln response or its bound
    Censoring kind;
};

/// Sums over rows in theta = (a / s, b / s, 1 / s): z = theta_2 y - theta_0 - theta_1 x.
Local cloud_likelihood(const std::vector<CloudRow>& rows, const VectorXd& theta)
{
    Local l{-HUGE_VAL, VectorXd::Zero(3), Eigen::MatrixXd::Zero(3, 3)};
    const double gamma = theta[2];
    if (!(gamma > 0.0)) return l;
    l.value = 0.0;
    for (const CloudRow& r : rows) {
        const double z = gamma * r.y - theta[0] - theta[1] * r.x;
        const LogTerm t = cloud_term(r.kind, z);
        const Vector3d by(-1.0, -r.x, r.y);
        l.value += r.weight * t.value;
        l.gradient += r.weight * t.d1 * by;
        l.hessian += r.weight * t.d2 * by * by.transpose();
        if (r.kind != Censoring::none) continue;
        l.value += r.weight * std::log(gamma);
        l.gradient[2] += r.weight / gamma;
        l.hessian(2, 2) -= r.weight / (gamma * gamma);
    }
    return l;
}

struct Line {
    double intercept, slope, squares; ///< sum of weighted squares of residuals
};

/// Least squares of what is observed, bounds as if they were observed if `all`.
Line least_squares(const std::vector<CloudRow>& rows, bool all)
{
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const CloudRow& r : rows) {
        if (!all && r.kind != Censoring::none) continue;
        n += r.weight;
        sx += r.weight * r.x;
        sy += r.weight * r.y;
    }
    const double mx = sx / n, my = sy / n;
    for (const CloudRow& r : rows) {
        if (!all && r.kind != Censoring::none) continue;
        sxx += r.weight * (r.x - mx) * (r.x - mx);
        sxy += r.weight * (r.x - mx) * (r.y - my);
    }
    Line line{0.0, sxx > 0.0 ? sxy / sxx : 0.0, 0.0};
    line.intercept = my - line.slope * mx;
    for (const CloudRow& r : rows) {
        const double e = r.y - line.intercept - line.slope * r.x;
        if (all || r.kind == Censoring::none) line.squares += r.weight * e * e;
    }
    return line;
}

CloudFit refused_cloud(ModelOutcome outcome, std::string reason)
{
    CloudFit f;
    f.outcome = outcome;
    f.reason = std::move(reason);
    return f;
}

} // namespace

CloudFit fit_cloud(std::span<const CloudPoint> points, bool unbiased)
{
    using enum ModelOutcome;
    std::vector<CloudRow> rows;
    double n = 0.0, seen = 0.0, mean = 0.0, first = NAN;
    bool spread = false;
    for (const CloudPoint& p : points) {
        const Observation& o = p.response;
        const Censoring kind = censoring(o, true);
        const double bound = bound_of(o, kind);
        if (!(p.intensity > 0.0) || !std::isfinite(p.intensity) || !(bound > 0.0) ||
            !std::isfinite(bound) || !(o.weight >= 0.0) || kind == Censoring::interval)
            return refused_cloud(invalid_value, "intensities and responses must be above 0");
        if (o.weight == 0.0) continue;
        rows.push_back({std::log(p.intensity), std::log(bound), o.weight, kind});
        n += o.weight;
        mean += o.weight * rows.back().x;
        if (kind != Censoring::none) continue;
        seen += 1.0;
        spread = spread || (!std::isnan(first) && rows.back().x != first);
        first = std::isnan(first) ? rows.back().x : first;
    }
    if (rows.empty()) return refused_cloud(no_data, "no data");
    if (seen < 3.0) return refused_cloud(no_data, "fewer than three responses are observed");
    if (!spread) return refused_cloud(no_contrast, "only one intensity");
    mean /= n;
    for (CloudRow& r : rows) r.x -= mean;
    const bool plain = seen == static_cast<double>(rows.size());
    const Line line = least_squares(rows, !plain);
    if (!(line.squares > 0.0)) return refused_cloud(separated, "no scatter about the line");
    const double sigma = std::sqrt(line.squares / n);
    VectorXd start(3);
    start << line.intercept / sigma, line.slope / sigma, 1.0 / sigma;
    const Maximum m =
        maximise([&](const VectorXd& theta) { return cloud_likelihood(rows, theta); }, start);
    if (!m.converged) return refused_cloud(not_converged, "the likelihood has no maximum");
    CloudFit f;
    f.outcome = converged;
    f.n = n;
    f.sigma = 1.0 / m.at[2];
    f.slope = m.at[1] * f.sigma;
    f.intercept = m.at[0] * f.sigma - f.slope * mean;
    f.log_likelihood = m.local.value;
    // (intercept, slope, ln sigma) by (delta, beta, gamma) of centred intensities
    Eigen::Matrix3d j;
    j << f.sigma, -mean * f.sigma, -f.intercept * f.sigma, 0.0, f.sigma, -f.slope * f.sigma,
        0.0, 0.0, -f.sigma;
    f.covariance = j * inverse_information(m.local.hessian) * j.transpose();
    if (plain && unbiased) f.sigma = std::sqrt(line.squares / (n - 2.0));
    return f;
}

CollapseFit fit_collapse(std::span<const CloudPoint> points, Link link)
{
    using enum ModelOutcome;
    CollapseFit f;
    f.link = link;
    double highest_standing = 0.0, lowest_collapse = HUGE_VAL, least = HUGE_VAL, most = 0.0;
    double collapses = 0.0, n = 0.0, mean = 0.0;
    for (const CloudPoint& p : points) {
        if (!(p.intensity > 0.0) || !std::isfinite(p.intensity)) {
            f.outcome = invalid_value;
            f.reason = "intensities must be above 0";
            return f;
        }
        const double w = p.response.weight;
        if (w == 0.0) continue;
        n += w;
        mean += w * std::log(p.intensity);
        collapses += p.collapsed ? w : 0.0;
        least = std::min(least, p.intensity);
        most = std::max(most, p.intensity);
        if (p.collapsed)
            lowest_collapse = std::min(lowest_collapse, p.intensity);
        else
            highest_standing = std::max(highest_standing, p.intensity);
    }
    const auto no = [&](ModelOutcome outcome, const char* why) {
        f.outcome = outcome;
        f.reason = why;
        return f;
    };
    if (n == 0.0) return no(no_data, "no data");
    if (collapses == 0.0)
        return no(absent_mode, "no collapse: its probability cannot be fitted");
    if (collapses == n)
        return no(absent_mode, "all collapsed: the probability cannot be fitted");
    if (least == most) return no(no_contrast, "only one intensity");
    if (highest_standing <= lowest_collapse)
        return no(separated, "the intensity tells collapses apart without error");
    mean /= n;
    const auto likelihood = [&](const VectorXd& theta) {
        Local l{0.0, VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 2)};
        for (const CloudPoint& p : points) {
            if (p.response.weight == 0.0) continue;
            const Eigen::Vector2d by(1.0, std::log(p.intensity) - mean);
            const double z = theta[0] + theta[1] * by[1];
            LogTerm t{};
            if (link == Link::probit)
                t = p.collapsed ? StandardNormal::log_cdf(z) : StandardNormal::log_survival(z);
            else
                t = p.collapsed ? StandardLogistic::log_cdf(z)
                                : StandardLogistic::log_survival(z);
            l.value += p.response.weight * t.value;
            l.gradient += p.response.weight * t.d1 * by;
            l.hessian += p.response.weight * t.d2 * by * by.transpose();
        }
        return l;
    };
    const Maximum m = maximise(likelihood, VectorXd::Zero(2));
    if (!m.converged) return no(not_converged, "the likelihood has no maximum");
    f.outcome = converged;
    f.slope = m.at[1];
    f.constant = m.at[0] - f.slope * mean;
    f.log_likelihood = m.local.value;
    return f;
}

double collapse_probability(const CollapseFit& fit, double intensity)
{
    const double z = fit.constant + fit.slope * std::log(intensity);
    return fit.link == Link::probit ? StandardNormal::cdf(z) : StandardLogistic::cdf(z);
}

double exceedance(const CloudFit& fit, double threshold, double intensity)
{
    return StandardNormal::cdf(
        (fit.intercept + fit.slope * std::log(intensity) - std::log(threshold)) / fit.sigma);
}

double exceedance(const CloudFit& standing, const CollapseFit& collapse, double threshold,
                  double intensity)
{
    const double fallen = collapse_probability(collapse, intensity);
    return exceedance(standing, threshold, intensity) * (1.0 - fallen) + fallen;
}

double share_reached(const IntensityCurve& curve, double x)
{
    return StandardNormal::cdf(std::log(x / curve.median) / curve.dispersion);
}

IntensityCurve cloud_curve(const CloudFit& fit, double threshold)
{
    return {std::exp((std::log(threshold) - fit.intercept) / fit.slope), fit.sigma / fit.slope};
}

} // namespace fragility
