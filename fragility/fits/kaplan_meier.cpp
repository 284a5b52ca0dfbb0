#include "fragility/fits/kaplan_meier.hpp"

#include "core/fit_factors.hpp"
#include "fragility/laws/standard_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

struct Here {
    double failed = 0.0, stopped = 0.0;
};

struct Tallied {
    double at;
    Here here;
};

std::vector<Tallied> tally(std::span<const Observation> data)
{
    std::vector<Tallied> all;
    all.reserve(data.size());
    for (std::size_t i = 0; i < data.size(); ++i) {
        const Observation& o = data[i];
        const Censoring kind = censoring(o, false);
        if (!(o.weight > 0.0) || !std::isfinite(o.lower) || std::isnan(o.upper) ||
            kind == Censoring::left || kind == Censoring::interval)
            throw std::invalid_argument("Kaplan-Meier: observation " + std::to_string(i + 1) +
                                        " is neither observed nor right-censored");
        const bool failed = kind == Censoring::none;
        all.push_back({o.lower, {failed ? o.weight : 0.0, failed ? 0.0 : o.weight}});
    }
    std::ranges::stable_sort(all, {}, &Tallied::at);
    std::size_t last = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].at == all[last].at) {
            all[last].here.failed += all[i].here.failed;
            all[last].here.stopped += all[i].here.stopped;
        } else {
            all[++last] = all[i];
        }
    all.resize(std::min(all.size(), last + 1));
    return all;
}

/// ln(-ln S) +- z s / (S |ln S|), 0 < S < 1: stays within [0, 1] (Kalbfleisch and Prentice).
/// Where the last wall has failed, S = 0 and the formula ends: the band before it goes up to 1.
core::Interval band(double survival, double greenwood, double confidence)
{
    const double z = core::fit_normal_factor(confidence);
    const double spread = std::exp(z * std::sqrt(greenwood) / std::abs(std::log(survival)));
    return {1.0 - std::pow(survival, 1.0 / spread), 1.0 - std::pow(survival, spread),
            confidence};
}

} // namespace

KaplanMeier kaplan_meier(std::span<const Observation> data, double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("Kaplan-Meier: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
    const std::vector<Tallied> all = tally(data);
    KaplanMeier k;
    double at_risk = 0.0;
    for (const Observation& o : data) at_risk += o.weight;
    double survival = 1.0;
    double greenwood = 0.0; // variance of ln survival
    for (const auto& [at, here] : all) {
        if (here.failed > 0.0) {
            const double left = at_risk - here.failed;
            const bool last = left <= 1e-12 * at_risk;
            survival = last ? 0.0 : survival * left / at_risk;
            if (!last) greenwood += here.failed / (at_risk * left);
            k.steps.push_back(
                {at, at_risk, here.failed, 1.0 - survival, survival * std::sqrt(greenwood),
                 last ? core::Interval{k.steps.empty() ? 0.0 : k.steps.back().band.lower, 1.0,
                                       confidence}
                      : band(survival, greenwood, confidence)});
        }
        at_risk -= here.failed + here.stopped;
        k.end = at;
    }
    return k;
}

} // namespace fragility
