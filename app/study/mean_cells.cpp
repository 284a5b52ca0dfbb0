#include "app/study/mean_cells.hpp"

#include "uq/estimates/estimate.hpp"

namespace app {

Number mean_cell(std::span<const double> values, int decimals, double scale)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.empty()) return {};
    if (sound.size() == 1) return plain_number(sound.front() * scale, decimals);
    const uq::Estimate e = uq::estimate_mean(sound);
    return with_error(e.value * scale, e.std_error * scale, decimals);
}

Number cov_cell(std::span<const double> values)
{
    const auto sound = uq::sound_values(values).values;
    if (sound.size() < 2) return {};
    const uq::Moments m = uq::moments(sound);
    return m.mean > 0.0 ? plain_number(m.sd / m.mean, 2) : Number{};
}

} // namespace app
