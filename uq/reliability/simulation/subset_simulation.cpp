#include "uq/reliability/simulation/subset_simulation.hpp"

#include "core/binomial.hpp"
#include "core/interval.hpp"
#include "uq/reliability/simulation/subset_simulation_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace uq {

namespace {

using Rows = std::vector<Eigen::Index>;

std::size_t chain_length(const SubsetOptions& o)
{
    return static_cast<std::size_t>(std::lround(1.0 / o.level_share));
}

void check_options(const SubsetOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("subset simulation: " + what);
    };
    require(o.level_share > 0.0 && o.level_share <= 0.5, "level_share must be in (0, 1/2]");
    const double length = 1.0 / o.level_share;
    require(std::abs(length - std::round(length)) < 1e-9 * length,
            "level_share must be one over a whole number");
    require(o.samples >= chain_length(o) && o.samples % chain_length(o) == 0,
            "samples must be a multiple of 1 / level_share = " +
                std::to_string(chain_length(o)));
    require(o.max_levels >= 1, "max_levels must be at least 1");
    require(o.max_evaluations >= o.samples, "max_evaluations must allow one level at least");
    require(o.target_cov > 0.0, "target_cov must be > 0");
    require(o.confidence > 0.0 && o.confidence < 1.0, "confidence must be in (0, 1)");
}

/// One run, or the mean of several: then what is counted is counted over all.
struct Run {
    std::vector<SubsetLevel> levels;
    double reached = 1.0;     ///< probability of the last level's population
    double reached_cov = 0.0; ///< of it
    double reached_freedom = 1.0;
    double value = 0.0, cov = 0.0;
    double freedom = 1.0;      ///< degrees of freedom of `cov`
    std::size_t passed = 0;    ///< in the last population
    std::size_t samples = 0;   ///< in that population
    std::size_t ancestors = 0; ///< of those that passed
    std::size_t most_levels = 1;
    bool stuck = false;
    double failed_share = 0.0; ///< of the first level
};

Rows at_or_below(const Population& p, double threshold)
{
    Rows rows;
    for (Eigen::Index i = 0; i < p.g.size(); ++i)
        if (p.g(i) <= threshold) rows.push_back(i);
    return rows;
}

/// Scatter of the number of rows, as a sum over independent ancestors.
struct LineageScatter {
    double cov;     ///< coefficient of variation [-]
    double freedom; ///< degrees of freedom of that, >= 1
};

/// The variance is a sum of squares of families f, mostly of few large ones: it scatters like a
/// chi-squared variable with 2 (sum f^2)^2 / sum f^4 degrees of freedom, which has the same
/// first two moments (Satterthwaite 1946), less one for the mean.
LineageScatter lineage_scatter(const Population& p, const Rows& rows)
{
    const auto n = static_cast<double>(p.g.size());
    std::vector<double> family(p.ancestor.size(), 0.0);
    for (const Eigen::Index i : rows)
        family[static_cast<std::size_t>(p.ancestor[static_cast<std::size_t>(i)])] += 1.0;
    double square = 0.0, fourth = 0.0;
    for (const double f : family) {
        square += f * f;
        fourth += f * f * f * f;
    }
    const double mean = static_cast<double>(rows.size()) / n;
    if (p.g.size() < 2) return {1.0, 1.0};
    return {std::sqrt(std::max(0.0, square / n - mean * mean) / (n - 1.0)) / mean,
            std::max(1.0, 2.0 * square * square / fourth - 1.0)};
}

std::size_t ancestors(const Population& p, const Rows& rows)
{
    std::set<Eigen::Index> all;
    for (const Eigen::Index i : rows) all.insert(p.ancestor[static_cast<std::size_t>(i)]);
    return all.size();
}

/// `count` of the rows, by chance: where g has ties there are more at the threshold than
/// needed.
Rows choose(Rows rows, std::size_t count, std::uint64_t seed, std::uint64_t level)
{
    if (rows.size() <= count) return rows;
    Stream random(seed, level, Purpose::search);
    for (std::size_t i = 0; i < count; ++i)
        std::swap(rows[i], rows[i + random.below(rows.size() - i)]);
    rows.resize(count);
    return rows;
}

double smallest(const Eigen::VectorXd& g, std::size_t count)
{
    std::vector<double> sorted(g.begin(), g.end());
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(count - 1));
    return sorted[count - 1];
}

void finish(Run& r, const Population& p, double acceptance)
{
    const Rows rows = at_or_below(p, 0.0);
    const double share = static_cast<double>(rows.size()) / static_cast<double>(p.g.size());
    r.passed = rows.size();
    r.value = r.reached * share;
    if (!rows.empty()) {
        const LineageScatter scatter = lineage_scatter(p, rows);
        r.cov = scatter.cov;
        r.freedom = scatter.freedom;
    }
    r.samples = static_cast<std::size_t>(p.g.size());
    r.ancestors = ancestors(p, rows);
    r.levels.push_back({0.0, share, acceptance, r.ancestors});
    r.most_levels = r.levels.size();
}

/// The mean of `n` independent runs and one more.
Run with(const Run& mean, std::size_t n, const Run& more)
{
    const auto before = static_cast<double>(n), all = before + 1.0;
    const double first = before * mean.value * mean.cov, second = more.value * more.cov;
    const double error = std::hypot(first, second);
    Run r = mean;
    if (error > 0.0) // Welch (1947)
        r.freedom = std::pow(error, 4) /
                    (std::pow(first, 4) / mean.freedom + std::pow(second, 4) / more.freedom);
    r.value = (before * mean.value + more.value) / all;
    r.cov = error / (all * r.value);
    r.passed += more.passed;
    r.samples += more.samples;
    r.ancestors += more.ancestors;
    r.most_levels = std::max(r.most_levels, more.most_levels);
    r.failed_share = (before * mean.failed_share + more.failed_share) / all;
    return r;
}

Run run(const LimitState& s, const SubsetOptions& o, FailedAs failed, std::uint64_t seed,
        Ledger& ledger)
{
    const std::size_t chains = o.samples / chain_length(o);
    ChainState state{.seed = seed};
    Run r;
    const std::size_t failures = ledger.failed.size();
    Population p = first_population(s, o.samples, failed, state, ledger);
    r.failed_share =
        static_cast<double>(ledger.failed.size() - failures) / static_cast<double>(o.samples);
    for (int level = 1;; ++level) {
        const double threshold = smallest(p.g, chains);
        const Rows below = at_or_below(p, threshold);
        r.stuck =
            below.size() == o.samples || threshold == std::numeric_limits<double>::infinity();
        const bool affordable = ledger.evaluations + o.samples - chains <= o.max_evaluations;
        if (threshold <= 0.0 || r.stuck || level == o.max_levels || !affordable) break;
        const double share = static_cast<double>(below.size()) / static_cast<double>(o.samples);
        r.levels.push_back({threshold, share, state.acceptance, ancestors(p, below)});
        r.reached *= share;
        const LineageScatter scatter = lineage_scatter(p, below);
        r.reached_cov = scatter.cov;
        r.reached_freedom = scatter.freedom;
        p = next_population(s, p,
                            choose(below, chains, seed, static_cast<std::uint64_t>(level)),
                            threshold, failed, state, ledger);
    }
    finish(r, p, state.acceptance);
    return r;
}

core::Interval interval(const Run& r, const SubsetOptions& o)
{
    if (r.most_levels == 1)
        return core::binomial_interval(core::BinomialInterval::clopper_pearson,
                                       static_cast<double>(r.passed),
                                       static_cast<double>(r.samples), o.confidence);
    if (r.passed > 0) return log_interval(r.value, r.cov * r.value, o.confidence, r.freedom);
    core::Interval last =
        log_interval(r.reached, r.reached_cov * r.reached, o.confidence, r.reached_freedom);
    last.lower = 0.0;
    return last;
}

bool arrived(const Run& r, const SubsetOptions& o)
{
    return r.passed >= r.samples / chain_length(o);
}

SamplingOutcome outcome(const Run& r, const SubsetOptions& o, bool all_failed, bool arrived)
{
    if (all_failed) return SamplingOutcome::no_answer;
    if (r.passed == 0) return SamplingOutcome::none_passed;
    if (r.most_levels == 1 && r.value + r.failed_share >= 1.0)
        return SamplingOutcome::all_passed;
    return arrived && r.cov <= o.target_cov ? SamplingOutcome::target_reached
                                            : SamplingOutcome::limit_reached;
}

void warn(Exceedance& e, const Run& r)
{
    if (r.stuck && r.passed == 0)
        e.warnings.emplace_back("the limit state has one value over the whole last level, or "
                                "failed there: it cannot be approached");
    if (r.passed > 0 && r.most_levels > 1 && r.ancestors < kFewAncestors)
        e.warnings.push_back("only " + std::to_string(r.ancestors) +
                             " independent samples are behind this probability: its standard "
                             "error is unreliable; a larger budget gives more");
}

} // namespace

SubsetResult subset_simulation(const LimitState& s, const SubsetOptions& o)
{
    check(s);
    check_options(o);
    Ledger ledger;
    Run low = run(s, o, FailedAs::safe, o.seed, ledger);
    SubsetResult r{{}, low.levels, arrived(low, o)};
    for (std::size_t longest = ledger.evaluations;
         r.arrived && low.cov > o.target_cov && ledger.failed.empty() &&
         longest <= o.max_evaluations - ledger.evaluations;
         ++r.runs) {
        const std::size_t before = ledger.evaluations;
        low = with(low, r.runs,
                   run(s, o, FailedAs::safe, replicate_seed(o.seed, 1 + r.runs), ledger));
        longest = std::max(longest, ledger.evaluations - before);
    }
    const bool failures = !ledger.failed.empty();
    const bool unknown = failures && ledger.evaluations + o.samples > o.max_evaluations;
    const Run high = failures && !unknown
                         ? run(s, o, FailedAs::passed, replicate_seed(o.seed, 1), ledger)
                         : low;
    Exceedance& e = r.exceedance;
    const bool all_failed = low.failed_share >= 1.0;
    e.lower = low.value;
    e.upper = unknown ? 1.0 : std::max(low.value, high.value);
    e.outcome = outcome(low, o, all_failed, r.arrived);
    if (!all_failed) {
        e.estimate.value = std::min(1.0, low.value / (1.0 - low.failed_share));
        e.estimate.std_error = low.cov * e.estimate.value;
    }
    e.estimate.failed = ledger.failed.size();
    e.estimate.n = ledger.evaluations - ledger.failed.size();
    const core::Interval a = interval(low, o), b = interval(high, o);
    e.estimate.interval = {a.lower, all_failed || unknown ? 1.0 : std::max(a.upper, b.upper),
                           o.confidence};
    warn(e, low);
    e.ledger = std::move(ledger);
    return r;
}

} // namespace uq
