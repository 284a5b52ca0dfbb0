#include "app/study/answers/mean_cells.hpp"

#include "core/moments.hpp"
#include "core/sample_quantile.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <array>

namespace app {

Number mean_cell(std::span<const double> values, int decimals, double scale)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.empty()) return {};
    if (sound.size() == 1) return plain_number(sound.front() * scale, decimals);
    const uq::Estimate e = uq::estimate_mean(sound);
    return with_error(e.value * scale, e.std_error * scale, decimals);
}

Number median_cell(std::span<const fragility::Observation> data, double confidence,
                   int decimals)
{
    if (data.empty()) return {};
    constexpr std::array kHalf = {0.5};
    const auto median = fragility::observed_quantiles(data, kHalf, confidence).front();
    if (median.value) return with_interval(*median.value, median.interval, decimals);
    const double lower = median.interval.lower;
    double tested = fragility::known_to(data);
    if (fragility::is_known(tested, lower)) tested = lower; // runs that ended together
    return {.value = tested,
            .lower = std::min(lower, tested),
            .upper = median.interval.upper,
            .decimals = decimals,
            .sense = Sense::at_least};
}

Number cov_cell(std::span<const double> values)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.size() < 2) return {};
    const core::Moments m = core::moments(sound);
    return m.mean > 0.0 ? plain_number(m.sd / m.mean, 2) : Number{};
}

Number median_number(std::vector<double> values, int decimals)
{
    if (values.empty()) return {};
    std::ranges::sort(values);
    return plain_number(core::sample_quantile(values, 0.5), decimals);
}

} // namespace app
