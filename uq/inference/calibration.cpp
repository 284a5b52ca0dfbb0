#include "uq/inference/calibration.hpp"

#include "core/normal.hpp"
#include "uq/designs/stream.hpp"
#include "uq/inference/bounded_normal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace uq {
namespace {

const double kLogTwoPi = std::log(2.0 * std::numbers::pi);
constexpr int kStartTries = 200; ///< of one chain
constexpr int kLonger = 4;
constexpr double kLeastVariance =
    1e-200; ///< of a test: its square root and inverse are numbers

/// A scale with a half-t prior (four degrees of freedom), from a coordinate with a standard
/// normal one. The quantile of Student's t is that of Shaw (2006), J. Comput. Finance 9(4),
/// 37-73, with its difference of cosines as a product.
double half_t(double coordinate, double scale)
{
    const double p = core::normal_cdf(coordinate);
    const double beyond =
        std::max(core::normal_survival(coordinate), std::numeric_limits<double>::min());
    const double cosine = std::sqrt(beyond * (1.0 + p)), third = std::atan2(p, cosine) / 3.0;
    return scale * std::sqrt(8.0 * std::sin(2.0 * third) * std::sin(third) / cosine);
}

/// The tests of one answer under a point: what they say of the discrepancy d ~ N(0, V). Mean
/// and squares about it are taken in test by test: differences of large sums would make a
/// likelihood without end of one exact test.
struct AnswerTests {
    int n = 0;                      ///< values seen
    double precision = 0.0;         ///< of 1 / v_j
    double mean = 0.0;              ///< of y - m, weighed by 1 / v_j
    double squares = 0.0;           ///< of (y - m - mean)^2 / v_j
    double log_scale = 0.0;         ///< of ln(v_j) / 2
    std::vector<NoisyBound> bounds; ///< y - m

    void see(double residual, double variance)
    {
        const double weight = 1.0 / variance, off = residual - mean;
        const double share = weight / (precision + weight);
        squares += off * off * precision * share;
        mean += share * off;
        precision += weight;
        log_scale += 0.5 * std::log(variance);
        ++n;
    }
};

std::vector<AnswerTests> tests_under(const CalibrationProblem& p, const CalibrationPoint& at,
                                     const ModelAnswers& m)
{
    std::vector<AnswerTests> all(p.quantity.size());
    for (const MeasuredAnswer& t : p.tests) {
        AnswerTests& a = all[t.answer];
        const auto i = static_cast<Eigen::Index>(t.answer);
        const double s = at.s(static_cast<Eigen::Index>(p.quantity[t.answer]));
        const double variance = std::max(
            s * s + t.error * t.error + (p.own.size() > 0 ? p.own(i) : 0.0), kLeastVariance);
        const double residual = t.value - m.mean(i);
        if (t.at_least) {
            a.bounds.push_back({residual, std::sqrt(variance)});
            continue;
        }
        a.see(residual, variance);
    }
    return all;
}

/// The discrepancy of an answer given the values seen, bounds aside.
struct SeenDiscrepancy {
    double mean, variance;
    double shrink; ///< 1 + prior * precision
};

SeenDiscrepancy discrepancy_of(const AnswerTests& a, double prior)
{
    const double shrink = 1.0 + prior * a.precision;
    return {prior * a.precision / shrink * a.mean, prior / shrink, shrink};
}

double discrepancy_prior(const CalibrationProblem& p, const CalibrationPoint& at,
                         const ModelAnswers& m, std::size_t answer)
{
    const double tau = at.tau(static_cast<Eigen::Index>(p.quantity[answer]));
    return tau * tau + m.variance(static_cast<Eigen::Index>(answer));
}

Eigen::Index quantities(const CalibrationProblem& p)
{
    return 1 + static_cast<Eigen::Index>(*std::ranges::max_element(p.quantity));
}

Eigen::Index coordinates_of(const CalibrationProblem& p)
{
    return p.inputs + (p.discrepancy ? 2 : 1) * quantities(p);
}

LogDensity posterior_density(const CalibrationProblem& p)
{
    return [&p](const Eigen::VectorXd& x) {
        return -0.5 * (x.squaredNorm() + static_cast<double>(x.size()) * kLogTwoPi) +
               log_likelihood(p, calibration_point(p, x));
    };
}

/// Draws of the prior where the density is not zero.
Eigen::MatrixXd starts_of(const CalibrationProblem& p, const LogDensity& f,
                          const MetropolisOptions& o)
{
    Eigen::MatrixXd starts(o.chains, coordinates_of(p));
    for (int k = 0; k < o.chains; ++k) {
        Stream random(o.seed, static_cast<std::uint64_t>(k), Purpose::search);
        Eigen::VectorXd x(starts.cols());
        int tries = 0;
        do {
            if (++tries > kStartTries)
                throw std::invalid_argument(
                    "calibration: the tests are impossible wherever the prior was tried");
            for (double& v : x) v = random.normal();
        } while (!std::isfinite(f(x)));
        starts.row(k) = x.transpose();
    }
    return starts;
}

void diagnose_all(CalibrationPosterior& posterior)
{
    posterior.r_hat = 1.0;
    posterior.effective = std::numeric_limits<double>::infinity();
    const auto chains = static_cast<Eigen::Index>(posterior.chains.size());
    const Eigen::MatrixXd& first = posterior.chains.front().draws;
    for (Eigen::Index c = 0; c < first.cols(); ++c) {
        Eigen::MatrixXd y(first.rows(), chains);
        for (Eigen::Index k = 0; k < chains; ++k)
            y.col(k) = posterior.chains[static_cast<std::size_t>(k)].draws.col(c);
        const ChainDiagnostics d = diagnose(y);
        posterior.r_hat = std::max(posterior.r_hat, d.r_hat);
        posterior.effective = std::min(posterior.effective, d.effective);
    }
}

} // namespace

void check(const CalibrationProblem& p)
{
    const auto refuse = [](bool bad, const char* why) {
        if (bad) throw std::invalid_argument("calibration: " + std::string(why));
    };
    refuse(p.inputs < 1, "there must be an input");
    refuse(!p.model, "there must be a model");
    refuse(p.quantity.empty(), "there must be an answer");
    for (std::size_t q = 0; q < static_cast<std::size_t>(quantities(p)); ++q)
        refuse(std::ranges::count(p.quantity, q) == 0, "quantities must have no gaps");
    refuse(p.tests.empty(), "there must be a test");
    for (const MeasuredAnswer& t : p.tests) {
        refuse(t.answer >= p.quantity.size(), "a test is of an answer that there is not");
        refuse(!std::isfinite(t.value), "a test must be a finite number");
        refuse(!(t.error >= 0.0 && std::isfinite(t.error)), "an error must be >= 0");
    }
    refuse(p.own.size() != 0 && p.own.size() != static_cast<Eigen::Index>(p.quantity.size()),
           "scatter of walls must be given of each answer");
    refuse(p.own.size() != 0 && !(p.own.allFinite() && p.own.minCoeff() >= 0.0),
           "scatter of walls must be >= 0");
    refuse(!(p.prior_scale > 0.0 && std::isfinite(p.prior_scale)), "prior_scale must be > 0");
}

CalibrationPoint calibration_point(const CalibrationProblem& p, const Eigen::VectorXd& x)
{
    const Eigen::Index n = quantities(p);
    CalibrationPoint at{x.head(p.inputs), Eigen::VectorXd::Zero(n), Eigen::VectorXd(n)};
    for (Eigen::Index q = 0; q < n; ++q) {
        at.s(q) = half_t(x(p.inputs + q), p.prior_scale);
        if (p.discrepancy) at.tau(q) = half_t(x(p.inputs + n + q), p.prior_scale);
    }
    return at;
}

double log_likelihood(const CalibrationProblem& p, const CalibrationPoint& at)
{
    const ModelAnswers m = p.model(at.z);
    const std::vector<AnswerTests> all = tests_under(p, at, m);
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const AnswerTests& a = all[i];
        if (a.n == 0 && a.bounds.empty()) continue;
        const double prior = discrepancy_prior(p, at, m, i);
        const SeenDiscrepancy d = discrepancy_of(a, prior);
        const double misfit = a.squares + a.mean * a.mean * a.precision / d.shrink;
        sum += -0.5 * a.n * kLogTwoPi - a.log_scale - 0.5 * std::log(d.shrink) - 0.5 * misfit +
               log_beyond(a.bounds, d.mean, d.variance);
    }
    return std::isnan(sum) ? -std::numeric_limits<double>::infinity() : sum;
}

bool has_converged(const CalibrationPosterior& posterior)
{
    return posterior.r_hat <= kConvergedRHat && posterior.effective >= kConvergedSize;
}

CalibrationPosterior calibrate(const CalibrationProblem& problem, const CalibrationOptions& o)
{
    check(problem);
    const LogDensity f = posterior_density(problem);
    const Eigen::MatrixXd starts = starts_of(problem, f, o.metropolis);
    MetropolisOptions steps = o.metropolis;
    CalibrationPosterior posterior;
    for (int round = 0;; ++round) {
        posterior.chains = adaptive_metropolis(f, starts, steps);
        diagnose_all(posterior);
        if (has_converged(posterior) || round == o.longer) break;
        steps.warm_up *= kLonger;
        steps.draws *= kLonger;
    }
    if (o.evidence)
        posterior.evidence = bridge_evidence(f, posterior.chains, o.metropolis.seed);
    return posterior;
}

std::vector<CalibrationPoint> calibration_points(const CalibrationProblem& problem,
                                                 const CalibrationPosterior& posterior,
                                                 std::size_t n)
{
    const auto rows = static_cast<std::size_t>(posterior.chains.front().draws.rows());
    const std::size_t all = rows * posterior.chains.size();
    std::vector<CalibrationPoint> points;
    for (std::size_t i = 0; i < n; ++i) {
        // the middle of the i-th of n equal parts
        const std::size_t k = (2 * i + 1) * all / (2 * n);
        points.push_back(
            calibration_point(problem, posterior.chains[k / rows]
                                           .draws.row(static_cast<Eigen::Index>(k % rows))
                                           .transpose()));
    }
    return points;
}

Eigen::MatrixXd further_tests(const CalibrationProblem& p,
                              const std::vector<CalibrationPoint>& points, std::uint64_t seed)
{
    const auto n = static_cast<Eigen::Index>(p.quantity.size());
    Eigen::MatrixXd y(static_cast<Eigen::Index>(points.size()), n);
    for (std::size_t k = 0; k < points.size(); ++k) {
        Stream random(seed, k, Purpose::prediction);
        const CalibrationPoint& at = points[k];
        const ModelAnswers m = p.model(at.z);
        const std::vector<AnswerTests> all = tests_under(p, at, m);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto answer = static_cast<std::size_t>(i);
            const SeenDiscrepancy seen =
                discrepancy_of(all[answer], discrepancy_prior(p, at, m, answer));
            const double d = draw_beyond(all[answer].bounds, seen.mean, seen.variance, random);
            const double s = at.s(static_cast<Eigen::Index>(p.quantity[answer]));
            const double deviation = std::sqrt(s * s + (p.own.size() > 0 ? p.own(i) : 0.0));
            y(static_cast<Eigen::Index>(k), i) = m.mean(i) + d + deviation * random.normal();
        }
    }
    return y;
}

} // namespace uq
