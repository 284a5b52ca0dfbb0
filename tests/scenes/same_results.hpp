#pragma once
/// Two stored walls, compared bit for bit.

#include "app/store/store_row.hpp"

#include <cstring>
#include <vector>

namespace scenes {

template <class T>
[[nodiscard]] bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Equal to the bit (a NaN equals the same NaN; 0 and -0 differ) in all but `cost`.
[[nodiscard]] inline bool same_results(const app::WallRow& a, const app::WallRow& b)
{
    return a.key == b.key && a.status == b.status && a.reason == b.reason &&
           same_bits(a.inputs, b.inputs) && same_bits(a.responses, b.responses) &&
           same_bits(a.counts, b.counts) &&
           same_bits(a.curve.displacement, b.curve.displacement) &&
           same_bits(a.curve.force, b.curve.force) && same_bits(a.piers.facts, b.piers.facts) &&
           same_bits(a.piers.movement, b.piers.movement) &&
           same_bits(a.piers.shear, b.piers.shear) &&
           same_bits(a.spandrels.facts, b.spandrels.facts);
}

} // namespace scenes
