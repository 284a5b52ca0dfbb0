#include "fragility/limits/hierarchical_normal.hpp"

#include "core/gauss_legendre.hpp"
#include "core/level_normal.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

namespace fragility {
namespace {

struct Node {
    double at, weight;
};

/// Composite rule of 16 nodes between each edge and the next, ascending.
std::vector<Node> rule_between(const std::vector<double>& edges)
{
    std::vector<Node> nodes;
    for (std::size_t p = 0; p + 1 < edges.size(); ++p) {
        const double half = 0.5 * (edges[p + 1] - edges[p]);
        const double middle = edges[p] + half;
        for (std::size_t i = core::kGauss16.node.size(); i-- > 0;)
            nodes.push_back(
                {middle - half * core::kGauss16.node[i], half * core::kGauss16.weight[i]});
        for (std::size_t i = 0; i < core::kGauss16.node.size(); ++i)
            nodes.push_back(
                {middle + half * core::kGauss16.node[i], half * core::kGauss16.weight[i]});
    }
    return nodes;
}

/// Composite rule of `panels` x 16 nodes on [lower, upper], ascending.
std::vector<Node> rule_on(double lower, double upper, std::size_t panels)
{
    std::vector<double> edges;
    for (std::size_t p = 0; p <= panels; ++p)
        edges.push_back(lower +
                        (upper - lower) * static_cast<double>(p) / static_cast<double>(panels));
    return rule_between(edges);
}

/// Nodes of the scatter r = sqrt(tau^2 + s^2) on (0, infinity), as u of r = unit u / (1 - u).
/// Tests that agree leave a unit far below the prior's scale, up to which the error of their
/// level is not known: panels are added, each twice as long in r as the one before, until they
/// pass the prior's scale.
std::vector<Node> scatter_rule(double unit, std::size_t panels, const ScalePrior& prior)
{
    std::vector<double> edges;
    for (std::size_t p = 0; p < panels; ++p)
        edges.push_back(static_cast<double>(p) / static_cast<double>(panels));
    for (double left = 0.5 * (1.0 - edges.back()); unit / left < 2.0 * prior.half_t;
         left *= 0.5)
        edges.push_back(1.0 - left);
    edges.push_back(1.0);
    return rule_between(edges);
}

/// Shares of tau and of s in r.
struct Shares {
    double tau, s, weight;
};

/// Nodes of the angle between both, close where one of them is small. A known error leaves tau
/// alone.
std::vector<Shares> share_rule(bool known_error)
{
    if (known_error) return {{1.0, 0.0, 1.0}};
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    std::vector<Shares> shares;
    for (const Node& n : rule_between({0.0, 0.03, 0.1, 0.3, 0.7, 0.9, 0.97, 1.0})) {
        const double root = std::sin(kQuarter * n.at), angle = kQuarter * root * root;
        shares.push_back({std::sin(angle), std::cos(angle),
                          n.weight * kQuarter * kQuarter * std::sin(2.0 * kQuarter * n.at)});
    }
    return shares;
}

double prior_density(double scale, const ScalePrior& prior)
{
    return prior.half_t > 0.0 ? std::pow(1.0 + 0.25 * std::pow(scale / prior.half_t, 2), -2.5)
                              : 1.0;
}

/// A level under given tau and s: what its values say of mu. They are counted from their mean,
/// lest squares of far values leave no digit of what they differ by.
struct Level {
    double centre = 0.0;
    core::LevelSums seen;
    std::vector<std::pair<double, double>> bounds; ///< censored: y, s
};

double error_of(const LevelledValue& v, double s) { return v.error > 0.0 ? v.error : s; }

/// Mean of the values seen of each level; 0 without any.
std::vector<double> centres_of(std::span<const LevelledValue> data, std::size_t n)
{
    std::vector<double> sum(n, 0.0), seen(n, 0.0);
    for (const LevelledValue& v : data) {
        if (v.at_least) continue;
        sum[v.level] += v.value;
        seen[v.level] += 1.0;
    }
    for (std::size_t i = 0; i < n; ++i) sum[i] /= std::max(1.0, seen[i]);
    return sum;
}

std::vector<Level> levels_of(std::span<const LevelledValue> data,
                             const std::vector<double>& centres, double s)
{
    std::vector<Level> levels;
    for (const double centre : centres) levels.push_back({centre, {}, {}});
    for (const LevelledValue& v : data) {
        Level& l = levels[v.level];
        const double error = error_of(v, s), value = v.value - l.centre;
        if (v.at_least) {
            l.bounds.emplace_back(value, error);
            continue;
        }
        const double w = 1.0 / (error * error);
        l.seen.precision += w;
        l.seen.sum += w * value;
        l.seen.squares += w * value * value;
        l.seen.log_scale += std::log(error);
    }
    return levels;
}

/// ln of the likelihood of the values of a level for one mu, and the mean of mu + d.
struct LevelTerm {
    double log_likelihood, mean;
};

LevelTerm level_term(const Level& l, double common, double tau)
{
    const double mu = common - l.centre;
    // d has precision 1 / tau^2; with the values seen x = mu + d is normal (mean, variance)
    const core::LevelNormal x = core::level_normal(l.seen, mu, tau * tau);
    const double precision = l.seen.precision,
                 mean = precision > 0.0 ? l.seen.sum / precision : 0.0;
    // within the level, and of its mean about mu
    const double misfit =
        l.seen.squares - mean * l.seen.sum + std::pow(mean - mu, 2) * precision / x.shrink;
    LevelTerm term{-l.seen.log_scale - 0.5 * std::log(x.shrink) - 0.5 * misfit,
                   l.centre + x.mean};
    if (l.bounds.empty()) return term;
    static const std::vector<Node> kRule = rule_on(-7.0, 7.0, 2);
    double total = 0.0, moment = 0.0;
    for (const Node& n : kRule) {
        const double at = x.mean + std::sqrt(x.variance) * n.at;
        double p = n.weight * std::exp(StandardNormal::log_density(n.at).value);
        for (const auto& [bound, error] : l.bounds)
            p *= StandardNormal::survival((bound - at) / error);
        total += p;
        moment += p * at;
    }
    if (!(total > 0.0)) return {-core::kInfinity, term.mean};
    return {term.log_likelihood + std::log(total), l.centre + moment / total};
}

/// Where mu lies for given tau and s: a bound pulls it up, but less than a value at the larger
/// of the bound and the mean of the values seen would.
std::pair<double, double> mu_range(std::span<const LevelledValue> data, std::size_t n,
                                   double tau, double s)
{
    const auto mean = [&](double least, bool all) {
        std::vector<double> precision(n, 0.0), sum(n, 0.0);
        for (const LevelledValue& v : data) {
            if (v.at_least && !(all && v.value > least)) continue;
            const double w = 1.0 / (error_of(v, s) * error_of(v, s));
            precision[v.level] += w;
            sum[v.level] += w * v.value;
        }
        double p = 0.0, y = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double shrink = 1.0 + tau * tau * precision[i];
            p += precision[i] / shrink;
            y += sum[i] / shrink;
        }
        return std::pair{y / p, 1.0 / std::sqrt(p)};
    };
    const auto [seen, error] = mean(0.0, false);
    return {seen - 8.0 * error, std::max(seen, mean(seen, true).first) + 8.0 * error};
}

/// @return number of levels
std::size_t check(std::span<const LevelledValue> data, const ScalePrior& prior)
{
    std::size_t n = 0, seen = 0, known = 0;
    for (const LevelledValue& v : data) {
        if (!std::isfinite(v.value) || !(v.error >= 0.0) || !std::isfinite(v.error))
            throw std::invalid_argument("hierarchical model: a value or an error is no number");
        n = std::max(n, v.level + 1);
        seen += v.at_least ? 0 : 1;
        known += v.error > 0.0 ? 1 : 0;
    }
    if (seen < 3)
        throw std::invalid_argument("hierarchical model: fewer than three values are observed");
    if (known != 0 && known != data.size())
        throw std::invalid_argument(
            "hierarchical model: an error is known of some values only");
    for (std::size_t i = 0; i < n; ++i)
        if (std::ranges::count(data, i, &LevelledValue::level) == 0)
            throw std::invalid_argument("hierarchical model: a level without values");
    if (!(prior.half_t >= 0.0))
        throw std::invalid_argument("hierarchical model: a prior without scale");
    if (prior.half_t == 0.0 && (n < 3 || known == 0))
        throw std::invalid_argument(
            "hierarchical model: a flat prior needs three levels and known errors");
    return n;
}

/// The size of the scales: the standard deviation of the values seen.
double spread(std::span<const LevelledValue> data)
{
    double n = 0.0, mean = 0.0, square = 0.0;
    for (const LevelledValue& v : data) n += v.at_least ? 0.0 : 1.0;
    for (const LevelledValue& v : data) mean += v.at_least ? 0.0 : v.value / n;
    for (const LevelledValue& v : data)
        square += v.at_least ? 0.0 : (v.value - mean) * (v.value - mean) / n;
    return std::max(std::sqrt(square), 1e-3);
}

void add_moments(HierarchicalPosterior& posterior)
{
    for (const auto& p : posterior.points) {
        posterior.mu += p.weight * p.mu;
        posterior.tau += p.weight * p.tau;
        posterior.scatter += p.weight * (p.tau * p.tau + p.s * p.s);
    }
    for (const auto& p : posterior.points) {
        posterior.mu_error += p.weight * std::pow(p.mu - posterior.mu, 2);
        posterior.tau_error += p.weight * std::pow(p.tau - posterior.tau, 2);
    }
    posterior.mu_error = std::sqrt(posterior.mu_error);
    posterior.tau_error = std::sqrt(posterior.tau_error);
    posterior.scatter = std::sqrt(posterior.scatter);
}

/// Smallest x at which a function that rises reaches p.
template <class Rising> double inverse(Rising rising, double lower, double upper, double p)
{
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (lower + upper);
        (rising(middle) < p ? lower : upper) = middle;
    }
    return 0.5 * (lower + upper);
}

constexpr std::size_t kNodes = 2 * core::kGauss16.node.size(); // of a panel

constexpr double kNothing = 1e-18; // a million such points change no printed digit

/// P_k(x) for k = 0 to n - 1, of Legendre.
std::vector<double> legendre(double x, std::size_t n)
{
    std::vector<double> p = {1.0, x};
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double degree = static_cast<double>(k);
        p.push_back(((2.0 * degree + 1.0) * x * p[k] - degree * p[k - 1]) / (degree + 1.0));
    }
    return p;
}

/// The part of the weights of a panel that lies below x in [-1, 1]: the integral of the
/// polynomial through the densities at its nodes.
double part_below(std::span<const double, kNodes> weights, double x)
{
    static const auto kAtNodes = [] {
        std::array<std::vector<double>, kNodes> all;
        const std::vector<Node> nodes = rule_on(-1.0, 1.0, 1);
        for (std::size_t i = 0; i < kNodes; ++i) all[i] = legendre(nodes[i].at, kNodes);
        return all;
    }();
    const std::vector<double> at_x = legendre(x, kNodes + 1);
    double part = 0.0;
    for (std::size_t k = 0; k < kNodes; ++k) {
        double moment = 0.0;
        for (std::size_t i = 0; i < kNodes; ++i) moment += weights[i] * kAtNodes[i][k];
        part += 0.5 * moment * (at_x[k + 1] - (k == 0 ? -1.0 : at_x[k - 1]));
    }
    return part;
}

/// Share of the weights below y, of nodes that come panel by panel.
/// @param at position of node k;  weight its weight;  n number of nodes
template <class At, class Weight>
double share_below(double y, std::size_t n, At at, Weight weight)
{
    const double end = rule_on(-1.0, 1.0, 1).back().at; // the last node of a panel
    double below = 0.0;
    for (std::size_t first = 0; first < n; first += kNodes) {
        const double middle = 0.5 * (at(first) + at(first + kNodes - 1)),
                     half = (at(first + kNodes - 1) - middle) / end, x = (y - middle) / half;
        if (x <= -1.0) continue;
        std::array<double, kNodes> weights;
        double all = 0.0;
        for (std::size_t i = 0; i < kNodes; ++i) all += weights[i] = weight(first + i);
        below += x >= 1.0 || all < kNothing ? all : part_below(weights, x);
    }
    return below;
}

} // namespace

HierarchicalPosterior hierarchical_posterior(std::span<const LevelledValue> data,
                                             const ScalePrior& prior)
{
    const std::size_t n = check(data, prior);
    const bool known = data.front().error > 0.0;
    const double unit = spread(data);
    const std::vector<double> centres = centres_of(data, n);
    const std::vector<Node> radii = scatter_rule(unit, known ? 16 : 2, prior);
    const std::vector<Shares> shares = share_rule(known);
    HierarchicalPosterior posterior;
    posterior.unit = unit;
    posterior.level_means.assign(n, 0.0);
    std::vector<double> log_weights, means;
    for (const Node& u : radii) {
        const double r = unit * u.at / (1.0 - u.at),
                     stretch = u.weight * unit / ((1.0 - u.at) * (1.0 - u.at));
        for (const Shares& share : shares) {
            const double tau = r * share.tau, s = r * share.s;
            const double scales = stretch * share.weight * (known ? 1.0 : r) *
                                  prior_density(tau, prior) * prior_density(s, prior);
            const std::vector<Level> levels = levels_of(data, centres, s);
            const auto [lower, upper] = mu_range(data, n, tau, s);
            for (const Node& mu : rule_on(lower, upper, 3)) {
                double log_weight = std::log(scales) + std::log(mu.weight);
                for (const Level& l : levels) {
                    const LevelTerm term = level_term(l, mu.at, tau);
                    log_weight += term.log_likelihood;
                    means.push_back(term.mean);
                }
                log_weights.push_back(log_weight);
                posterior.points.push_back({0.0, mu.at, tau, s});
            }
        }
    }
    const double most = std::ranges::max(log_weights);
    double total = 0.0;
    for (std::size_t k = 0; k < log_weights.size(); ++k)
        total += posterior.points[k].weight = std::exp(log_weights[k] - most);
    for (std::size_t k = 0; k < log_weights.size(); ++k) {
        posterior.points[k].weight /= total;
        for (std::size_t i = 0; i < n; ++i)
            posterior.level_means[i] += posterior.points[k].weight * means[k * n + i];
    }
    const std::size_t each = posterior.points.size() / radii.size();
    for (std::size_t k = 0; k < posterior.points.size(); ++k) {
        if (k % each == 0) posterior.scatters.push_back({radii[k / each].at, 0.0});
        posterior.scatters.back().weight += posterior.points[k].weight;
    }
    add_moments(posterior);
    return posterior;
}

double mu_quantile(const HierarchicalPosterior& posterior, double p)
{
    const auto& points = posterior.points;
    const auto [least, most] =
        std::ranges::minmax(points, {}, &HierarchicalPosterior::Point::mu);
    return inverse(
        [&](double mu) {
            return share_below(
                mu, points.size(), [&](std::size_t k) { return points[k].mu; },
                [&](std::size_t k) { return points[k].weight; });
        },
        least.mu, most.mu, p);
}

double scatter_quantile(const HierarchicalPosterior& posterior, double p)
{
    const auto& nodes = posterior.scatters;
    const double u = inverse(
        [&](double at) {
            return share_below(
                at, nodes.size(), [&](std::size_t k) { return nodes[k].at; },
                [&](std::size_t k) { return nodes[k].weight; });
        },
        0.0, 1.0, p);
    return posterior.unit * u / (1.0 - u);
}

core::Interval predictive_interval(const HierarchicalPosterior& posterior, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("predictive interval: a confidence not in (0, 1)");
    std::vector<HierarchicalPosterior::Point> points;
    for (const auto& point : posterior.points)
        if (point.weight > kNothing) points.push_back(point);
    const auto cdf = [&](double y) {
        double p = 0.0;
        for (const auto& point : points)
            p += point.weight *
                 StandardNormal::cdf((y - point.mu) / std::hypot(point.tau, point.s));
        return p;
    };
    const double wide =
        100.0 * std::hypot(posterior.scatter, posterior.mu_error) + std::abs(posterior.mu);
    const auto at = [&](double p) { return inverse(cdf, -wide, wide, p); };
    return {at(0.5 * (1.0 - confidence)), at(0.5 * (1.0 + confidence)), confidence};
}

} // namespace fragility
