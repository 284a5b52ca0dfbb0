#include "app/store/store_row.hpp"

#include <cstring>

namespace app {

namespace {

template <class T> bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_curve(const WallCurve& a, const WallCurve& b)
{
    if (!same_bits(a.displacement, b.displacement) || !same_bits(a.force, b.force) ||
        a.further.size() != b.further.size())
        return false;
    for (std::size_t k = 0; k < a.further.size(); ++k)
        if (!same_bits(a.further[k], b.further[k])) return false;
    return true;
}

} // namespace

std::string wall_name(WallKey key)
{
    return "wall (level " + std::to_string(key.level) + ", sample " +
           std::to_string(key.sample) + ")";
}

bool same_results(const WallRow& a, const WallRow& b)
{
    return a.key == b.key && a.status == b.status && a.reason == b.reason &&
           same_bits(a.inputs, b.inputs) && same_bits(a.responses, b.responses) &&
           same_bits(a.counts, b.counts) && same_curve(a.curve, b.curve);
}

} // namespace app
