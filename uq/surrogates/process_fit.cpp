#include "uq/surrogates/process_fit.hpp"

#include <Eigen/Cholesky>
#include <nlopt.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace uq {

namespace {

constexpr std::array kStartLengths = {0.5, 1.5, 4.0,
                                      10.0};     // [standard deviations of an input]; tuned
constexpr std::array kStartNoises = {1e-4, 0.1}; // [variances of the response]; tuned
constexpr std::size_t kFollowed = 2;
constexpr double kLeastNoise = 1e-8, kMostNoise = 2.0; // [variances of the response]
constexpr double kShortest = 0.05, kLongest = 100.0;   // [standard deviations of an input]
constexpr double kLeastVariance = 1e-4, kMostVariance = 1e6; // [variances of the response]
constexpr double kHopeless = 1e100; // minus the log likelihood where K has no factor

/// Data with every column of mean 0 and mean square 1.
struct ScaledFit {
    ProcessData data;
    ProcessFitOptions options;
    Eigen::RowVectorXd x_scale;
    double y_scale;
    bool noise_estimated;
};

double deviation(const Eigen::VectorXd& v)
{
    return std::sqrt((v.array() - v.mean()).square().mean());
}

ScaledFit scaled_fit(const ProcessData& data, const ProcessFitOptions& options)
{
    ScaledFit s{data, options, Eigen::RowVectorXd::Ones(data.x.cols()), deviation(data.y),
                !options.noise.has_value()};
    if (!(s.y_scale > 0.0) || !std::isfinite(s.y_scale))
        throw std::invalid_argument("process: the response does not vary");
    for (Eigen::Index k = 0; k < data.x.cols(); ++k) {
        const double scale = deviation(data.x.col(k));
        if (scale > 0.0) s.x_scale(k) = scale;
        s.data.x.col(k) = (data.x.col(k).array() - data.x.col(k).mean()) / s.x_scale(k);
    }
    s.data.y = (data.y.array() - (options.trend == ProcessTrend::none ? 0.0 : data.y.mean())) /
               s.y_scale;
    s.data.noise /= s.y_scale * s.y_scale;
    return s;
}

/// Logarithms of lengths, variance and, where it is estimated, noise.
ProcessParameters parameters_of(const ScaledFit& s, const std::vector<double>& t)
{
    const auto d = s.data.x.cols();
    ProcessParameters p{std::exp(t[d]), Eigen::VectorXd(d),
                        s.noise_estimated ? std::exp(t[d + 1])
                                          : *s.options.noise / (s.y_scale * s.y_scale)};
    for (Eigen::Index k = 0; k < d; ++k) p.lengths(k) = std::exp(t[k]);
    return p;
}

/// d (log likelihood) / d t = 1/2 sum_ij (w w' - Q)_ij dK_ij / dt with w = K^-1 (y - F b), Q =
/// K^-1.
void add_gradient(const GaussianProcess& p, bool noise_estimated, std::vector<double>& gradient)
{
    const Eigen::Index n = p.data.y.size(), d = p.data.x.cols();
    const Eigen::MatrixXd inverse_factor =
        p.factor.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    m.selfadjointView<Eigen::Lower>().rankUpdate(inverse_factor.transpose(), -1.0);
    m.selfadjointView<Eigen::Lower>().rankUpdate(p.weights);
    const double trace = m.trace();
    double by_variance = 0.0;
    Eigen::VectorXd by_length = Eigen::VectorXd::Zero(d);
    for (Eigen::Index j = 0; j < n; ++j) {
        by_variance += 0.5 * m(j, j) * p.parameters.variance;
        const Eigen::Index below = n - j - 1;
        if (below == 0) continue;
        Eigen::VectorXd r2 = Eigen::VectorXd::Zero(below);
        for (Eigen::Index k = 0; k < d; ++k)
            r2.array() += (p.scaled.col(k).tail(below).array() - p.scaled(j, k)).square();
        Eigen::VectorXd slope(below);
        for (Eigen::Index i = 0; i < below; ++i) {
            const double weight = p.parameters.variance * m(j + 1 + i, j);
            by_variance += weight * process_correlation(p.kernel, r2(i));
            slope(i) = weight * process_slope(p.kernel, r2(i));
        }
        for (Eigen::Index k = 0; k < d; ++k)
            by_length(k) += (slope.array() *
                             (p.scaled.col(k).tail(below).array() - p.scaled(j, k)).square())
                                .sum();
    }
    for (Eigen::Index k = 0; k < d; ++k) gradient[k] = -by_length(k);
    gradient[d] = -by_variance;
    if (noise_estimated) gradient[d + 1] = -0.5 * trace * p.parameters.noise;
}

double minus_likelihood(const std::vector<double>& t, std::vector<double>& gradient, void* data)
{
    const ScaledFit& s = *static_cast<const ScaledFit*>(data);
    std::ranges::fill(gradient, 0.0);
    try {
        const GaussianProcess p =
            condition(s.data, s.options.kernel, s.options.trend, parameters_of(s, t));
        if (!gradient.empty()) add_gradient(p, s.noise_estimated, gradient);
        return -p.log_likelihood;
    } catch (const std::invalid_argument&) { // K has no factor here
        return kHopeless;
    }
}

struct ProcessStart {
    std::vector<double> t;
    double value;
};

std::vector<ProcessStart> process_starts(ScaledFit& s)
{
    std::vector<ProcessStart> starts;
    std::vector<double> none;
    for (const double noise : kStartNoises) {
        if (!s.noise_estimated && noise != kStartNoises.front()) continue;
        for (const double length : kStartLengths) {
            std::vector<double> t(static_cast<std::size_t>(s.data.x.cols()), std::log(length));
            t.push_back(0.0);
            if (s.noise_estimated) t.push_back(std::log(noise));
            starts.push_back({t, minus_likelihood(t, none, &s)});
        }
    }
    std::ranges::stable_sort(starts, {}, &ProcessStart::value);
    return starts;
}

/// Climbs from a start, in place.
void follow(ScaledFit& s, ProcessStart& start)
{
    const auto d = static_cast<std::size_t>(s.data.x.cols());
    nlopt::opt search(nlopt::LD_SLSQP, static_cast<unsigned>(start.t.size()));
    std::vector<double> lower(start.t.size(), std::log(kShortest)),
        upper(start.t.size(), std::log(kLongest));
    lower[d] = std::log(kLeastVariance);
    upper[d] = std::log(kMostVariance);
    if (s.noise_estimated) {
        lower[d + 1] = std::log(kLeastNoise);
        upper[d + 1] = std::log(kMostNoise);
    }
    search.set_lower_bounds(lower);
    search.set_upper_bounds(upper);
    search.set_min_objective(minus_likelihood, &s);
    search.set_maxeval(s.options.evaluations);
    search.set_ftol_abs(1e-6);
    ProcessStart end = start;
    try {
        search.optimize(end.t, end.value);
    } catch (const std::runtime_error&) { // rounding, or no way down: as far as it came
    }
    std::vector<double> none;
    end.value = minus_likelihood(end.t, none, &s);
    if (end.value < start.value) start = end;
}

} // namespace

GaussianProcess fit_process(const ProcessData& data, const ProcessFitOptions& options)
{
    if (data.x.rows() != data.y.size() || !data.x.allFinite() || !data.y.allFinite())
        throw std::invalid_argument(
            "process: x and y must be finite, with the same number of rows");
    ScaledFit s = scaled_fit(data, options);
    std::vector<ProcessStart> starts = process_starts(s);
    starts.resize(std::min(kFollowed, starts.size()));
    for (ProcessStart& start : starts) follow(s, start);
    const ProcessStart& best = *std::ranges::min_element(starts, {}, &ProcessStart::value);
    ProcessParameters p = parameters_of(s, best.t);
    p.lengths = p.lengths.cwiseProduct(s.x_scale.transpose()).eval();
    p.variance *= s.y_scale * s.y_scale;
    p.noise *= s.y_scale * s.y_scale;
    return condition(data, options.kernel, options.trend, p);
}

} // namespace uq
