#include "fragility/fits/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fragility {

StoppingPoints::StoppingPoints(std::span<const Observation> walls)
{
    // Kaplan-Meier with the roles exchanged: a stop is the event, an observed value ends the
    // sight of it. At a tie the observed value came first.
    struct Seen {
        double at;
        bool stop;
        auto operator<=>(const Seen&) const = default;
    };
    std::vector<Seen> seen;
    for (const Observation& o : walls) {
        const bool stop = o.lower != o.upper;
        seen.push_back({o.lower, stop});
        value_.push_back(o.lower);
        own_.push_back(stop ? o.lower : std::numeric_limits<double>::quiet_NaN());
    }
    std::ranges::sort(seen);
    double share = 1.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i].stop) continue;
        share *= 1.0 - 1.0 / static_cast<double>(seen.size() - i);
        if (!at_.empty() && at_.back() == seen[i].at) {
            survival_.back() = share;
        } else {
            at_.push_back(seen[i].at);
            survival_.push_back(share);
        }
    }
}

double StoppingPoints::draw(std::size_t wall, double u) const
{
    if (!std::isnan(own_[wall])) return own_[wall];
    const auto first =
        static_cast<std::size_t>(std::ranges::upper_bound(at_, value_[wall]) - at_.begin());
    const double beyond = first == 0 ? 1.0 : survival_[first - 1];
    for (std::size_t i = first; i < at_.size(); ++i)
        if (survival_[i] <= (1.0 - u) * beyond) return at_[i];
    return std::numeric_limits<double>::infinity();
}

std::vector<Observation> draw_law(const Distribution& law, const StoppingPoints& stops,
                                  std::size_t walls, const RandomBits& bits,
                                  std::uint64_t replicate)
{
    std::vector<Observation> data;
    data.reserve(walls);
    for (std::size_t k = 0; k < walls; ++k) {
        const double x = quantile(law, uniform(bits(replicate, 2 * k)));
        const double stop = stops.draw(k, uniform(bits(replicate, 2 * k + 1)));
        data.push_back(x < stop ? observed(x) : right_censored(stop));
    }
    return data;
}

} // namespace fragility
