#include "fragility/intensity/sufficiency.hpp"

#include "core/boost_quantiles.hpp"
#include "fragility/intensity/cloud_term.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <map>
#include <stdexcept>

namespace fragility {
namespace {

/// Derivative of a point's ln likelihood by the line at its intensity, in units of sigma.
struct Score {
    double score, information;
    Eigen::Vector2d by; ///< 1, ln intensity
};

Score score_of(const CloudPoint& p, const CloudFit& fit)
{
    const Censoring kind = censoring(p.response, true);
    const double x = std::log(p.intensity), y = std::log(bound_of(p.response, kind));
    const LogTerm t = cloud_term(kind, (y - fit.intercept - fit.slope * x) / fit.sigma);
    const double weight = p.response.weight;
    return {-weight * t.d1, -weight * t.d2, {1.0, x}};
}

/// P(|T| > |t|) of Student's law.
double two_sided_student(double t, double freedom)
{
    return core::beta_probability(0.5 * freedom, 0.5, freedom / (freedom + t * t));
}

} // namespace

SufficiencyTest test_sufficiency(std::span<const CloudPoint> points, const CloudFit& fit,
                                 std::span<const double> feature,
                                 std::span<const std::size_t> record)
{
    if (feature.size() != points.size() || record.size() != points.size())
        throw std::invalid_argument(
            "test_sufficiency: each point needs a feature and a record");
    const auto refused = [](ModelOutcome outcome, std::string reason) {
        return SufficiencyTest{outcome, std::move(reason), 1.0};
    };
    if (fit.outcome != ModelOutcome::converged) return refused(fit.outcome, fit.reason);
    // The part of the feature that the line explains, in the metric of the information.
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d shared = Eigen::Vector2d::Zero();
    double own = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Score s = score_of(points[i], fit);
        information += s.information * s.by * s.by.transpose();
        shared += s.information * feature[i] * s.by;
        own += s.information * feature[i] * feature[i];
    }
    const Eigen::Vector2d explained = information.ldlt().solve(shared);
    std::map<std::size_t, double> of_record;
    double left = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Score s = score_of(points[i], fit);
        const double w = feature[i] - explained.dot(s.by);
        of_record[record[i]] += s.score * w;
        left += s.information * w * w;
    }
    constexpr double kSame = 1e-12; // rounding of a feature that is a function of the measure
    if (!(left > kSame * own))
        return refused(ModelOutcome::no_contrast, "the feature is the measure itself");
    const auto n = static_cast<double>(of_record.size());
    if (of_record.size() < kSufficiencyRecords)
        return refused(ModelOutcome::no_data,
                       "fewer than " + std::to_string(kSufficiencyRecords) + " records");
    double sum = 0.0, squares = 0.0;
    for (const auto& [_, score] : of_record) {
        sum += score;
        squares += score * score;
    }
    if (!(squares > 0.0)) return refused(ModelOutcome::separated, "no scatter about the line");
    const double freedom = n - 2.0;
    const double t = sum * std::sqrt(freedom / (n * squares - sum * sum));
    return {ModelOutcome::converged, "", two_sided_student(t, freedom)};
}

} // namespace fragility
