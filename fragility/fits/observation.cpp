#include "fragility/fits/observation.hpp"

#include "core/interval.hpp"
#include "fragility/curve/limit_states.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace fragility {

Observation observed(double value) { return {value, value}; }
Observation right_censored(double lower) { return {lower, core::kInfinity}; }
Observation left_censored(double upper) { return {-core::kInfinity, upper}; }

std::optional<Observation> observation(const LimitDisplacement& reading, double scale)
{
    if (!(scale > 0.0 && scale < core::kInfinity))
        throw std::invalid_argument("observation: scale must be positive and finite");
    switch (reading.reading) {
    case Reading::observed:
        return Observation{scale * reading.displacement, scale * reading.displacement, 1.0,
                           is_capped(reading)};
    case Reading::censored:
        return right_censored(scale * reading.displacement);
    case Reading::not_defined:
        break;
    }
    return std::nullopt;
}

Censoring censoring(const Observation& o, bool positive)
{
    if (o.lower == o.upper) return Censoring::none;
    if (o.upper == core::kInfinity) return Censoring::right;
    if (o.lower == -core::kInfinity || (positive && o.lower == 0.0)) return Censoring::left;
    return Censoring::interval;
}

Counts count(std::span<const Observation> data, bool positive)
{
    Counts c;
    for (const Observation& o : data) {
        c.n += o.weight;
        switch (censoring(o, positive)) {
        case Censoring::none:
            c.observed += o.weight;
            break;
        case Censoring::right:
            c.right += o.weight;
            break;
        case Censoring::left:
            c.left += o.weight;
            break;
        case Censoring::interval:
            c.interval += o.weight;
            break;
        }
    }
    return c;
}

std::vector<Cap> caps(std::span<const Observation> data)
{
    std::map<double, double> walls;
    for (const Observation& o : data)
        if (o.capped) walls[o.lower] += o.weight;
    std::vector<Cap> found;
    for (const auto& [value, n] : walls) found.push_back({value, n});
    return found;
}

double known_to(std::span<const Observation> data)
{
    double end = 0.0;
    for (const Observation& o : data) end = std::max(end, o.lower);
    return end;
}

double common_end(std::span<const Observation> data)
{
    const double largest = known_to(data);
    double end = largest;
    for (const Observation& o : data)
        if (o.lower < o.upper && o.lower >= largest * (1.0 - kEndsTogether))
            end = std::min(end, o.lower);
    return end;
}

} // namespace fragility
