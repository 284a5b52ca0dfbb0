#include "fragility/fits/censored_fit.hpp"

#include "core/interval.hpp"
#include "fragility/fits/censored_likelihood.hpp"
#include "fragility/laws/maximise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fragility {
namespace {

/// Dispersion, against the spread of the data, beyond which a fit counts as running away [-].
constexpr double kWidest = 1e6;
/// Range of the coefficient of variation of a gamma law; its likelihood loses digits outside.
constexpr double kGammaLeast = 1e-3;
constexpr double kGammaMost = 10.0;

template <class Standard> Local scaled_local(const CensoredSample& s, const Eigen::VectorXd& x)
{
    Local l{-core::kInfinity, Eigen::VectorXd(2), Eigen::MatrixXd(2, 2)};
    if (!(x[1] > 0.0)) return l;
    const ScaledSum t = scaled_sum<Standard>(s, x[0], x[1]);
    l.value = t.value;
    l.gradient << t.d, t.g;
    l.hessian << t.dd, t.dg, t.dg, t.gg;
    return l;
}

Local gamma_local(const CensoredSample& s, const Eigen::VectorXd& x)
{
    if (!(x[1] > std::log(kGammaLeast) && x[1] < std::log(kGammaMost)) ||
        !(std::abs(x[0] - s.shift) < 100.0))
        return {-core::kInfinity, Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 2)};
    const Likelihood l = log_likelihood(s, x);
    return {l.value, l.gradient, l.hessian};
}

/// delta and gamma of the standardised axis.
Eigen::VectorXd scaled_start(const CensoredSample& s, const Distribution* start)
{
    if (!start) return Eigen::Vector2d(0.0, 1.0);
    const double gamma = s.scale / start->dispersion;
    return Eigen::Vector2d((start->location - s.shift) / s.scale * gamma, gamma);
}

struct Found {
    bool converged;
    bool ran_away;
    int iterations;
    Distribution law;
};

template <class Standard>
Found find_location_scale(const CensoredSample& s, const Distribution* start)
{
    const Maximum m =
        maximise([&](const Eigen::VectorXd& x) { return scaled_local<Standard>(s, x); },
                 scaled_start(s, start));
    const double gamma = m.at[1];
    const bool ran_away = !(gamma > 1.0 / kWidest) || !(std::abs(m.at[0] / gamma) < kWidest);
    return {m.converged,
            ran_away,
            m.iterations,
            {s.law, s.shift + s.scale * (m.at[0] / gamma), s.scale / gamma}};
}

Found find(const CensoredSample& s, const Distribution* start)
{
    if (s.law == Law::weibull) return find_location_scale<SmallestExtreme>(s, start);
    if (s.law != Law::gamma) return find_location_scale<StandardNormal>(s, start);
    Distribution first;
    if (start) {
        first = *start;
    } else {
        const Found near = find_location_scale<StandardNormal>(s, nullptr);
        if (!near.converged || near.ran_away) return near;
        const double variance = std::min(near.law.dispersion * near.law.dispersion, 1.0);
        first = {Law::gamma, near.law.location + 0.5 * variance,
                 std::max(std::sqrt(std::expm1(variance)), 2.0 * kGammaLeast)};
    }
    const Maximum m =
        maximise([&](const Eigen::VectorXd& x) { return gamma_local(s, x); }, working(first));
    const bool ran_away =
        !m.converged && (m.at[1] > std::log(0.9 * kGammaMost) || m.at[0] - s.shift > 50.0);
    return {m.converged, ran_away, m.iterations, distribution(Law::gamma, m.at)};
}

std::optional<Refusal> screen_values(Law law, std::span<const Observation> data)
{
    for (std::size_t i = 0; i < data.size(); ++i) {
        const Observation& o = data[i];
        const std::string which = "observation " + std::to_string(i + 1) + ": ";
        if (std::isnan(o.lower) || std::isnan(o.upper))
            return Refusal{FitOutcome::invalid_value, which + "an end is not a number"};
        if (!(o.lower <= o.upper) || o.lower == core::kInfinity || o.upper == -core::kInfinity)
            return Refusal{FitOutcome::invalid_value,
                           which + "lower end must not lie above the upper one"};
        if (!(o.weight > 0.0 && o.weight < core::kInfinity))
            return Refusal{FitOutcome::invalid_value,
                           which + "weight must be positive and finite"};
        if (positive(law) &&
            (o.upper <= 0.0 || (o.lower < 0.0 && o.lower > -core::kInfinity) ||
             (o.lower == o.upper && o.lower < std::numeric_limits<double>::min())))
            return Refusal{FitOutcome::not_positive, which + "a " + std::string(name(law)) +
                                                         " law has positive values only"};
        const bool open_below =
            o.lower == -core::kInfinity || (positive(law) && o.lower == 0.0);
        if (open_below && o.upper == core::kInfinity)
            return Refusal{FitOutcome::invalid_value, which + "says nothing"};
    }
    return std::nullopt;
}

std::string shown(double x)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

std::optional<Refusal> screen_caps(std::span<const Observation> data, double n)
{
    double capped = 0.0;
    for (const Cap& cap : caps(data)) capped += cap.walls;
    if (capped == 0.0) return std::nullopt;
    return Refusal{FitOutcome::capped, "a drift limit that is set comes first for " +
                                           shown(capped) + " of " + shown(n) +
                                           " walls, and no law describes it"};
}

std::optional<Refusal> screen_counts(const Counts& c, double highest_lower, double lowest_upper)
{
    if (c.right == c.n)
        return Refusal{FitOutcome::all_censored,
                       "not identifiable: all " + shown(c.n) +
                           " are right-censored, the highest at " + shown(highest_lower) +
                           "; only a lower bound on the median can be given"};
    if (c.left == c.n)
        return Refusal{FitOutcome::all_censored,
                       "not identifiable: all " + shown(c.n) +
                           " are left-censored, the lowest at " + shown(lowest_upper) +
                           "; only an upper bound on the median can be given"};
    const double informative = c.observed + c.interval + std::min(c.left, c.n - c.left);
    if (c.n < kFewestWalls || informative < kFewestInformative)
        return Refusal{FitOutcome::too_few,
                       shown(informative) + " of " + shown(c.n) +
                           " walls reached it; a curve needs 3 walls, of which 2 reached it"};
    return std::nullopt;
}

void complete(Fit& f, const CensoredSample& s)
{
    const Likelihood l = log_likelihood(s, working(f.law));
    const Eigen::Matrix2d information = -l.hessian;
    const Eigen::LLT<Eigen::Matrix2d> factor(information);
    if (factor.info() != Eigen::Success || !std::isfinite(l.value)) {
        f.law = {};
        f.outcome = FitOutcome::not_converged;
        f.reason = "the likelihood has no maximum where the search ended";
        return;
    }
    f.covariance = factor.solve(Eigen::Matrix2d::Identity());
    f.location_error = std::sqrt(f.covariance(0, 0));
    f.dispersion_error = f.law.dispersion * std::sqrt(f.covariance(1, 1));
    f.log_likelihood = l.value;
    f.aic = 4.0 - 2.0 * l.value;
    f.bic = 2.0 * std::log(f.counts.n) - 2.0 * l.value;
    f.outcome = FitOutcome::converged;
}

Counts count(const CensoredSample& s)
{
    Counts c;
    for (std::size_t i = 0; i < s.weight.size(); ++i) {
        c.n += s.weight[i];
        (i < s.observed                      ? c.observed
         : i < s.observed + s.right          ? c.right
         : i < s.observed + s.right + s.left ? c.left
                                             : c.interval) += s.weight[i];
    }
    return c;
}

} // namespace

std::optional<Refusal> screen(Law law, std::span<const Observation> data)
{
    if (data.empty()) return Refusal{FitOutcome::no_data, "no data"};
    if (auto refusal = screen_values(law, data)) return refusal;
    double highest_lower = -core::kInfinity;
    double lowest_upper = core::kInfinity;
    double size = 0.0;
    for (const Observation& o : data) {
        highest_lower = std::max(highest_lower, o.lower);
        lowest_upper = std::min(lowest_upper, o.upper);
        if (std::isfinite(o.lower)) size = std::max(size, std::abs(o.lower));
        if (std::isfinite(o.upper)) size = std::max(size, std::abs(o.upper));
    }
    const Counts c = count(data, positive(law));
    if (auto refusal = screen_caps(data, c.n)) return refusal;
    if (auto refusal = screen_counts(c, highest_lower, lowest_upper)) return refusal;
    if (!(highest_lower > lowest_upper + 1e-12 * size))
        return Refusal{FitOutcome::no_spread,
                       "all " + shown(c.n) + " agree with one and the same value: no curve"};
    return std::nullopt;
}

Fit fit(Law law, std::span<const Observation> data)
{
    if (const auto refusal = screen(law, data)) {
        Fit f;
        f.outcome = refusal->outcome;
        f.reason = refusal->reason;
        if (f.outcome != FitOutcome::invalid_value) f.counts = count(data, positive(law));
        f.law.law = law;
        return f;
    }
    return fit(prepare(law, data));
}

Fit fit(const CensoredSample& s, const Distribution* start)
{
    Fit f;
    f.counts = count(s);
    f.law.law = s.law;
    const Found found = find(s, start);
    f.iterations = found.iterations;
    if (found.ran_away) {
        f.outcome = FitOutcome::no_finite_fit;
        f.reason = "no finite fit: the likelihood grows with the dispersion without bound";
    } else if (!found.converged) {
        f.outcome = FitOutcome::not_converged;
        f.reason = "not converged after " + std::to_string(found.iterations) + " iterations";
    } else {
        f.law = found.law;
        complete(f, s);
    }
    return f;
}

} // namespace fragility
