#pragma once
/// Curves with closed forms.

#include "fragility/curve/curve_reading.hpp"

#include <initializer_list>
#include <utility>
#include <vector>

namespace scenes {

/// Owns what a fragility::Curve looks at.
struct OwnedCurve {
    std::vector<double> displacement, force;

    OwnedCurve(std::initializer_list<std::pair<double, double>> points)
    {
        for (const auto& [d, f] : points) {
            displacement.push_back(d);
            force.push_back(f);
        }
    }
    operator fragility::Curve() const
    {
        return {displacement, force};
    } // NOLINT: reads as a curve
};

inline OwnedCurve elastic_plastic() { return {{0.0, 0.0}, {1.0, 5.0}, {10.0, 5.0}}; }
inline OwnedCurve triangle() { return {{0.0, 0.0}, {1.0, 10.0}, {3.0, 0.0}}; }
inline OwnedCurve straight() { return {{0.0, 0.0}, {0.7, 2.1}, {3.0, 9.0}}; }
/// 80 % of the peak is crossed at 1 + 2/3 and at 3 + 1/3.
inline OwnedCurve jerky() { return {{0, 0}, {1, 10}, {2, 7}, {3, 9}, {4, 6}, {5, 5}}; }
/// Starts at its peak, without displacement.
inline OwnedCurve descending() { return {{0, 10}, {1, 9}, {5, 1}}; }
/// Pushed back all the way.
inline OwnedCurve negative() { return {{0, -1}, {1, -2}, {2, -1}}; }

} // namespace scenes
