#include "uq/reliability/simulation/multi_fidelity.hpp"

#include "uq/reliability/limit_state/exceedance.hpp"
#include "uq/reliability/simulation/crude_monte_carlo.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace uq {

namespace {

double now(const MultiFidelityOptions& o)
{
    using namespace std::chrono;
    if (o.now) return o.now();
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// One model and what it has answered so far: samples 0 .. y.size() - 1.
struct Asked {
    LimitState model;
    Eigen::VectorXd y; ///< quantity; not a number where it failed
    Ledger ledger;
    double seconds = 0.0;

    void ask(std::size_t n, const MultiFidelityOptions& o)
    {
        const auto known = static_cast<std::size_t>(y.size());
        if (n <= known) return;
        const double start = now(o);
        Eigen::VectorXd more =
            limit_values(model, normal_rows(o.seed, known, n - known, model.dimension), ledger);
        seconds += now(o) - start;
        if (o.quantity == Quantity::probability)
            for (double& v : more)
                if (!std::isnan(v)) v = v <= 0.0 ? 1.0 : 0.0;
        y.conservativeResize(static_cast<Eigen::Index>(n));
        y.tail(more.size()) = more;
    }
};

void check_all(const LimitState& s, const std::vector<CheapModel>& cheap,
               const MultiFidelityOptions& o)
{
    check(s);
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("multi-fidelity: " + what);
    };
    require(o.pilot >= 10, "pilot must be at least 10");
    require(o.expensive_cost >= 0.0 && std::isfinite(o.expensive_cost), "costs must be >= 0");
    require(o.budget > 0.0 && std::isfinite(o.budget), "budget must be > 0");
    require(o.confidence > 0.0 && o.confidence < 1.0, "confidence must be in (0, 1)");
    for (const CheapModel& c : cheap) {
        require(static_cast<bool>(c.model), "a cheap model is missing");
        require(c.cost >= 0.0 && std::isfinite(c.cost), "costs must be >= 0");
        require(c.response >= 0 && std::isfinite(c.threshold),
                "response must be >= 0 and threshold finite");
        require((c.cost > 0.0) == (o.expensive_cost > 0.0), "give all costs or none");
    }
}

/// The models as limit states; for a mean the threshold is zero and g is the response itself.
std::vector<Asked> asked(const LimitState& s, const std::vector<CheapModel>& cheap,
                         const MultiFidelityOptions& o)
{
    std::vector<Asked> all{{s, {}, {}, 0.0}};
    for (const CheapModel& c : cheap) {
        all.push_back({s, {}, {}, 0.0});
        all.back().model.model = c.model;
        all.back().model.response = c.response;
        all.back().model.threshold = c.threshold;
    }
    if (o.quantity == Quantity::mean)
        for (Asked& a : all) {
            a.model.threshold = 0.0;
            a.model.passing = Passing::at_or_below;
        }
    return all;
}

/// The value that stands for a failed sample of a cheap model.
double instead(const Asked& a, Quantity quantity, std::size_t pilot)
{
    if (quantity == Quantity::probability) return 0.0;
    double sum = 0.0;
    int n = 0;
    for (const double v : a.y.head(static_cast<Eigen::Index>(pilot)))
        if (!std::isnan(v)) sum += v, ++n;
    return n > 0 ? sum / n : 0.0;
}

Eigen::VectorXd filled(const Eigen::VectorXd& y, double value)
{
    return y.array().isNaN().select(Eigen::VectorXd::Constant(y.size(), value), y);
}

/// Values of the expensive model where it has one, and those of `use`: samples where the
/// expensive one failed are among the further samples of the cheap ones.
NestedValues nested(const std::vector<Asked>& all, const Eigen::VectorXd& expensive,
                    const std::vector<std::size_t>& use, const MultiFidelityOptions& o)
{
    std::vector<Eigen::Index> kept, failed;
    for (Eigen::Index i = 0; i < expensive.size(); ++i)
        (std::isnan(expensive(i)) ? failed : kept).push_back(i);
    NestedValues y{expensive(kept)};
    for (const std::size_t k : use) {
        const Asked& a = all[k + 1];
        const Eigen::VectorXd v = filled(a.y, instead(a, o.quantity, o.pilot));
        y.emplace_back(v.size());
        y.back() << v(kept), v(failed), v.tail(v.size() - expensive.size());
    }
    return y;
}

Eigen::VectorXd costs(const std::vector<Asked>& all, const std::vector<CheapModel>& cheap,
                      const MultiFidelityOptions& o)
{
    Eigen::VectorXd c(static_cast<Eigen::Index>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double given = i == 0 ? o.expensive_cost : cheap[i - 1].cost;
        const double measured = all[i].seconds / static_cast<double>(all[i].y.size());
        c(static_cast<Eigen::Index>(i)) = given > 0.0 ? given : std::max(measured, 1e-9);
    }
    return c;
}

/// rho^2 less what chance gives it in n samples (Ezekiel 1930); the sign is of no use here.
double shrunk(double correlation, Eigen::Index n)
{
    const auto m = static_cast<double>(n);
    return std::sqrt(
        std::max(0.0, 1.0 - (1.0 - correlation * correlation) * (m - 1.0) / (m - 2.0)));
}

/// Correlation of two indicators, with half a sample more in each way to differ: a pilot in
/// which they never differ does not show that they never do.
double doubted(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    const auto n = static_cast<double>(a.size());
    const double both = a.dot(b), p = (a.sum() + 0.5) / (n + 1.0),
                 q = (b.sum() + 0.5) / (n + 1.0);
    const double common = both / (n + 1.0) - p * q;
    return common / std::sqrt(p * (1.0 - p) * q * (1.0 - q));
}

void make_plan(MultiFidelityResult& r, const std::vector<Asked>& all,
               const MultiFidelityOptions& o)
{
    std::vector<std::size_t> every;
    for (std::size_t i = 1; i < all.size(); ++i) every.push_back(i - 1);
    const NestedValues y = nested(all, all[0].y, every, o);
    if (y[0].size() < 3)
        throw std::runtime_error(
            "multi-fidelity: fewer than 3 expensive samples of the pilot are "
            "sound; the first failure: " +
            all[0].ledger.failed.front().reason);
    r.correlation = controlled_mean(y, o.confidence).correlation;
    std::vector<CheapQuality> quality;
    for (Eigen::Index i = 0; i < r.correlation.size(); ++i) {
        const double rho =
            o.quantity == Quantity::mean || r.correlation(i) == 0.0
                ? r.correlation(i)
                : doubted(y[0], y[static_cast<std::size_t>(i) + 1].head(y[0].size()));
        quality.push_back({r.cost(i + 1), shrunk(rho, y[0].size())});
    }
    // The pilot of the cheap models is paid for, used or not.
    const double left =
        o.budget - r.cost.tail(r.cost.size() - 1).sum() * static_cast<double>(o.pilot);
    const double least = static_cast<double>(o.pilot) * r.cost(0);
    r.plan = plan_effort(r.cost(0), quality, std::max(left, least), o.pilot);
    if (r.plan.pays) return;
    r.reason = all.size() == 1 ? "there is no cheap model"
               : r.correlation.isZero(0.0)
                   ? "no correlation in the pilot: one of the quantities "
                     "is the same in all its samples"
                   : "correlations are too low for their costs";
}

void summarise(MultiFidelityResult& r, const std::vector<Asked>& all,
               const MultiFidelityOptions& o)
{
    const Eigen::VectorXd& expensive = all[0].y;
    const auto of = [&](const Eigen::VectorXd& y) {
        return controlled_mean(nested(all, y, r.plan.use, o), o.confidence);
    };
    // Indicators that have not been seen to differ may do so in one sample of n.
    const auto widened = [&](Estimate e) {
        if (o.quantity == Quantity::mean) return e;
        const double least = 1.0 / static_cast<double>(e.n);
        const double more = e.std_error > 0.0 ? std::max(1.0, least / e.std_error) : 1.0;
        e.std_error *= more;
        e.interval.lower = e.value - more * (e.value - e.interval.lower);
        e.interval.upper = e.value + more * (e.interval.upper - e.value);
        return e;
    };
    const ControlledMean m = of(expensive);
    r.estimate = widened(m.estimate);
    r.estimate.failed = r.expensive.failed.size();
    r.plain_std_error = m.plain_std_error;
    r.lower = r.upper = m.estimate.value;
    if (o.quantity == Quantity::mean) return;
    const Estimate safe = widened(of(filled(expensive, 0.0)).estimate);
    const Estimate passed = widened(of(filled(expensive, 1.0)).estimate);
    const auto share = [](double v) { return std::clamp(v, 0.0, 1.0); };
    r.estimate.value = share(m.estimate.value);
    r.lower = share(safe.value);
    r.upper = share(passed.value);
    r.estimate.interval = {share(safe.interval.lower), share(passed.interval.upper),
                           o.confidence};
    const auto count = static_cast<std::size_t>((expensive.array() == 1.0).count());
    if (r.plan.pays && count > 0 && count < r.estimate.n) return;
    // Without help, or without variance to be helped, shares have a better interval.
    const Exceedance e = count_exceedance(
        count, r.estimate.failed, static_cast<std::size_t>(expensive.size()), o.confidence);
    r.estimate = e.estimate;
    r.lower = e.lower;
    r.upper = e.upper;
}

} // namespace

MultiFidelityResult multi_fidelity(const LimitState& s, const std::vector<CheapModel>& cheap,
                                   const MultiFidelityOptions& o)
{
    check_all(s, cheap, o);
    std::vector<Asked> all = asked(s, cheap, o);
    for (Asked& a : all) a.ask(o.pilot, o);
    MultiFidelityResult r;
    r.cost = costs(all, cheap, o);
    if (o.budget < r.cost.sum() * static_cast<double>(o.pilot) * (1.0 - 1e-12))
        throw std::invalid_argument(
            "multi-fidelity: the budget does not reach for the pilot, " +
            std::to_string(r.cost.sum() * static_cast<double>(o.pilot)));
    make_plan(r, all, o);
    all[0].ask(r.plan.samples[0], o);
    for (std::size_t i = 0; i < r.plan.use.size(); ++i)
        all[r.plan.use[i] + 1].ask(r.plan.samples[i + 1], o);
    for (std::size_t i = 0; i < all.size(); ++i)
        r.spent += r.cost(static_cast<Eigen::Index>(i)) * static_cast<double>(all[i].y.size());
    for (std::size_t i = 1; i < all.size(); ++i)
        r.cheap_failed.push_back(all[i].ledger.failed.size());
    r.expensive = all[0].ledger;
    summarise(r, all, o);
    return r;
}

} // namespace uq
