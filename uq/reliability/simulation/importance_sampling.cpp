#include "uq/reliability/simulation/importance_sampling.hpp"

#include "uq/designs/stream.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace uq {

namespace {

void check_options(const LimitState& s, const Eigen::MatrixXd& centres,
                   const ImportanceOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("importance sampling: " + what);
    };
    require(centres.rows() >= 1, "there is no centre");
    require(centres.cols() == s.dimension,
            "centres must have the dimension of the limit state");
    require(centres.allFinite(), "centres must be finite");
    require(o.batch >= 1, "batch must be at least 1");
    require(o.max_samples >= 1, "max_samples must be at least 1");
    require(o.target_cov > 0.0, "target_cov must be > 0");
    require(o.defensive >= 0.0 && o.defensive < 1.0, "defensive must be in [0, 1)");
    require(o.confidence > 0.0 && o.confidence < 1.0, "confidence must be in (0, 1)");
}

/// The sampling density as a mixture; weights are relative to the standard normal density.
struct Mixture {
    Eigen::MatrixXd centres;
    Eigen::VectorXd share; ///< of each centre
    double defensive, width;

    Mixture(const Eigen::MatrixXd& at, double wide_share) : centres(at), defensive(wide_share)
    {
        const Eigen::VectorXd radius = at.rowwise().norm();
        // Phi(-r) over that of the nearest: no underflow far out.
        const double least = radius.minCoeff();
        share = (-0.5 * (radius.array().square() - least * least)).exp();
        share *= (1.0 - wide_share) / share.sum();
        width = std::max(1.0, least / std::sqrt(static_cast<double>(at.cols())));
    }

    Eigen::VectorXd draw(Stream& random) const
    {
        double left = random.uniform() - defensive;
        Eigen::VectorXd u(centres.cols());
        for (double& v : u) v = random.normal();
        if (left < 0.0) return width * u;
        Eigen::Index k = 0;
        while (k + 1 < share.size() && left >= share(k)) left -= share(k++);
        return centres.row(k).transpose() + u;
    }

    /// phi(u) / q(u)
    double weight(const Eigen::VectorXd& u) const
    {
        const auto d = static_cast<double>(u.size());
        const double square = u.squaredNorm();
        double q = defensive *
                   std::exp(0.5 * square * (1.0 - 1.0 / (width * width)) - d * std::log(width));
        for (Eigen::Index k = 0; k < share.size(); ++k)
            q += share(k) * std::exp(centres.row(k).dot(u.transpose()) -
                                     0.5 * centres.row(k).squaredNorm());
        return 1.0 / q;
    }

    /// Less than halfway to every centre, measured along its radius.
    bool unexplained(const Eigen::VectorXd& u) const
    {
        const Eigen::VectorXd along = centres * u;
        return (along.array() < 0.5 * centres.rowwise().squaredNorm().array()).all();
    }
};

/// Sums of weights, of all samples drawn so far.
struct Sums {
    double passed = 0.0, passed_square = 0.0, largest = 0.0, unexplained = 0.0;
    double failed = 0.0, failed_square = 0.0;
    std::size_t passed_count = 0, n = 0;

    void add(const Mixture& q, const Eigen::VectorXd& u, double g)
    {
        ++n;
        if (g > 0.0) return;
        const double w = q.weight(u);
        if (std::isnan(g)) {
            failed += w;
            failed_square += w * w;
            return;
        }
        ++passed_count;
        passed += w;
        passed_square += w * w;
        largest = std::max(largest, w);
        if (q.unexplained(u)) unexplained += w;
    }
};

/// Mean of n weights, of which the sums are known, and its standard error.
Estimate mean_weight(double sum, double square, std::size_t n)
{
    const auto count = static_cast<double>(n);
    const double mean = sum / count;
    const double variance = std::max(0.0, square / count - mean * mean);
    return {mean, n > 1 ? std::sqrt(variance / (count - 1.0)) : mean, n, 0, {}};
}

void warn(const std::string& what, double value, double limit, std::vector<std::string>& list)
{
    std::ostringstream text;
    text << what << ": " << value << " (limit " << limit << ")";
    list.push_back(text.str());
}

void judge_weights(ImportanceResult& r, const Sums& sums)
{
    std::vector<std::string>& list = r.exceedance.warnings;
    if (sums.passed_count == 0) return;
    r.effective = sums.passed * sums.passed / sums.passed_square;
    r.largest_share = sums.largest / sums.passed;
    r.unexplained_share = sums.unexplained / sums.passed;
    if (r.effective < kFewEffective)
        warn("weights degenerate, effective samples", r.effective, kFewEffective, list);
    if (r.largest_share > kLargeShare)
        warn("weights degenerate, share of one sample", r.largest_share, kLargeShare, list);
    // Where more than half passes, the origin's side of a plane is the passed one.
    if (r.unexplained_share > kUnexplainedShare && r.exceedance.estimate.value < 0.5)
        warn("share of the probability away from every design point, search for more",
             r.unexplained_share, kUnexplainedShare, list);
}

ImportanceResult summarise(const Sums& sums, std::size_t failed, const ImportanceOptions& o)
{
    ImportanceResult r;
    Exceedance& e = r.exceedance;
    e.estimate.interval = {0.0, 1.0, o.confidence};
    e.estimate.failed = failed;
    e.estimate.n = sums.n - failed;
    if (e.estimate.n == 0) return r;
    const Estimate passed = mean_weight(sums.passed, sums.passed_square, sums.n);
    const Estimate either =
        mean_weight(sums.passed + sums.failed, sums.passed_square + sums.failed_square, sums.n);
    const double sound = 1.0 - std::min(1.0, sums.failed / static_cast<double>(sums.n));
    e.lower = std::min(1.0, passed.value);
    e.upper = std::min(1.0, either.value);
    if (sums.passed_count == 0) {
        e.outcome = SamplingOutcome::none_passed;
        e.warnings.emplace_back("no sample passed: the centres are not near the limit state");
        return r;
    }
    e.estimate.value = sound > 0.0 ? std::min(1.0, passed.value / sound) : e.upper;
    e.estimate.std_error = sound > 0.0 ? passed.std_error / sound : passed.std_error;
    e.outcome = SamplingOutcome::limit_reached;
    e.estimate.interval.lower =
        log_interval(passed.value, passed.std_error, o.confidence).lower;
    e.estimate.interval.upper =
        log_interval(either.value, either.std_error, o.confidence).upper;
    judge_weights(r, sums);
    return r;
}

} // namespace

ImportanceResult importance_sampling(const LimitState& s, const Eigen::MatrixXd& centres,
                                     const ImportanceOptions& o)
{
    check(s);
    check_options(s, centres, o);
    const Mixture q(centres, o.defensive);
    Ledger ledger;
    Sums sums;
    ImportanceResult r;
    while (ledger.evaluations < o.max_samples) {
        const std::size_t n = std::min(o.batch, o.max_samples - ledger.evaluations);
        Eigen::MatrixXd u(static_cast<Eigen::Index>(n), s.dimension);
        for (Eigen::Index i = 0; i < u.rows(); ++i) {
            Stream random(o.seed, ledger.evaluations + static_cast<std::size_t>(i),
                          Purpose::importance);
            u.row(i) = q.draw(random).transpose();
        }
        const Eigen::VectorXd g = limit_values(s, u, ledger);
        for (Eigen::Index i = 0; i < u.rows(); ++i) sums.add(q, u.row(i).transpose(), g(i));
        r = summarise(sums, ledger.failed.size(), o);
        if (sums.passed_count > 0 && r.exceedance.warnings.empty() &&
            coefficient_of_variation(r.exceedance.estimate) <= o.target_cov) {
            r.exceedance.outcome = SamplingOutcome::target_reached;
            break;
        }
    }
    r.exceedance.ledger = std::move(ledger);
    return r;
}

} // namespace uq
