#include "app/sampling/study_design.hpp"

#include <stdexcept>

namespace app {

Eigen::MatrixXd unit_cube_of(const Study& study, int columns, std::uint64_t seed,
                             std::span<const std::uint32_t> sizes)
{
    uq::Design design{study.uq.design, {sizes.begin(), sizes.end()}, columns, seed};
    if (columns == 0) return Eigen::MatrixXd(sizes.back(), 0);
    try {
        return uq::unit_cube(design);
    } catch (const std::invalid_argument& bad) {
        throw error_at(study.source, "uq.design", bad.what());
    }
}

} // namespace app
