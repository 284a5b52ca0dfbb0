#include "fragility/fits/observed_quantile.hpp"

#include "core/boost_quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

/// From `at` to the next one.
struct Piece {
    double at;
    double share;       ///< Kaplan-Meier [-]
    double least, most; ///< bounds of the share [-]
};

/// A share is a product of quotients, rounded: 12 of 24 walls may come out a few units of the
/// last place below one half. Shares of different counts of walls differ by far more.
constexpr double kShareRounding = 1e-12;

bool reaches(double share, double p) { return share >= p * (1.0 - kShareRounding); }

/// Product of independent beta variables by its first two moments.
struct BetaProduct {
    double first = 1.0, second = 1.0;
    [[nodiscard]] BetaProduct times(double a, double b) const
    {
        return {first * a / (a + b), second * a * (a + 1.0) / ((a + b) * (a + b + 1.0))};
    }
    /// Quantile of the beta distribution with these moments.
    [[nodiscard]] double quantile(double p) const
    {
        const double variance = second - first * first;
        if (first >= 1.0 || variance <= 0.0) return first;
        const double size = first * (1.0 - first) / variance - 1.0;
        return core::beta_quantile(first * size, (1.0 - first) * size, p);
    }
};

std::vector<Observation> sorted(std::span<const Observation> data)
{
    std::vector<Observation> all(data.begin(), data.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Censoring kind = censoring(all[i], false);
        if (all[i].weight != 1.0 || !std::isfinite(all[i].lower) || std::isnan(all[i].upper) ||
            kind == Censoring::left || kind == Censoring::interval)
            throw std::invalid_argument("observed shares: observation " +
                                        std::to_string(i + 1) +
                                        " is neither observed nor right-censored");
    }
    std::ranges::sort(all, {}, &Observation::lower);
    return all;
}

std::vector<Piece> pieces(std::span<const Observation> data, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("observed shares: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    const auto all = sorted(data);
    const double tail = 0.5 - 0.5 * confidence;
    auto at_risk = static_cast<double>(all.size());
    std::vector<Piece> found = {
        {-core::kInfinity, 0.0, 0.0, all.empty() ? 1.0 : 1.0 - std::pow(tail, 1.0 / at_risk)}};
    double standing = 1.0;
    BetaProduct survival;
    for (std::size_t i = 0; i < all.size();) {
        const double at = all[i].lower;
        double failed = 0.0, stopped = 0.0;
        for (; i < all.size() && all[i].lower == at; ++i)
            (all[i].upper == at ? failed : stopped) += 1.0;
        if (failed > 0.0) {
            standing *= (at_risk - failed) / at_risk;
            survival = survival.times(at_risk - failed + 1.0, failed);
        }
        at_risk -= failed + stopped;
        const double most =
            at_risk > 0.0 ? 1.0 - survival.times(at_risk, 1.0).quantile(tail) : 1.0;
        found.push_back({at, 1.0 - standing, 1.0 - survival.quantile(1.0 - tail), most});
    }
    return found;
}

} // namespace

std::vector<ObservedQuantile> observed_quantiles(std::span<const Observation> data,
                                                 std::span<const double> shares,
                                                 double confidence)
{
    const auto known = pieces(data, confidence);
    const auto first = [&](auto&& reached) {
        const auto at = std::ranges::find_if(known, reached);
        return at == known.end() ? core::kInfinity : at->at;
    };
    std::vector<ObservedQuantile> found;
    for (const double p : shares) {
        if (!(p > 0.0 && p < 1.0))
            throw std::invalid_argument("observed quantiles: shares must be in (0, 1)");
        const double value = first([&](const Piece& x) { return reaches(x.share, p); });
        const double lower = first([&](const Piece& x) { return reaches(x.most, p); });
        const double upper = first([&](const Piece& x) { return reaches(x.least, p); });
        found.push_back({std::isfinite(value) ? std::optional(value) : std::nullopt,
                         {std::max(lower, 0.0), upper, confidence}});
    }
    return found;
}

std::vector<ObservedShare> observed_shares(std::span<const Observation> data,
                                           std::span<const double> values, double confidence)
{
    const auto known = pieces(data, confidence);
    std::vector<ObservedShare> found;
    for (const double x : values) {
        const auto after = std::ranges::upper_bound(known, x, {}, &Piece::at);
        const Piece& p = *(after - 1);
        const bool beyond = known.size() > 1 && x > known.back().at;
        found.push_back({p.share, {p.least, beyond ? 1.0 : p.most, confidence}});
    }
    return found;
}

} // namespace fragility
