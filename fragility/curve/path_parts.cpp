#include "fragility/curve/path_parts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fragility {
namespace {

int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

} // namespace

void check_path(const Path& path)
{
    if (path.displacement.size() != path.force.size())
        throw std::invalid_argument("path: as many displacements as forces are needed");
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(path.displacement.begin(), path.displacement.end(), finite) ||
        !std::all_of(path.force.begin(), path.force.end(), finite))
        throw std::invalid_argument("path: a displacement or force is not finite");
}

std::vector<Excursion> excursions(const Path& path)
{
    std::vector<Excursion> found;
    bool open = false;
    for (std::size_t i = 0; i < path.displacement.size(); ++i) {
        const int side = sign_of(path.displacement[i]);
        if (open && (side == 0 || side == found.back().side)) {
            found.back().end = i;
            open = side != 0;
        } else if (side != 0) {
            found.push_back({side, i > 0 ? i - 1 : 0, i});
            open = true;
        }
    }
    return found;
}

} // namespace fragility
