#pragma once
/// Numbers of kWallNumbers as cells and columns of tables.

#include "app/output/table/cells.hpp"
#include "app/output/table/table_columns.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "fragility/curve/drift.hpp"

#include <cmath>

namespace app {

/// "peak [kN]"
[[nodiscard]] inline Head number_head(const WallNumber& n, unsigned holds = 0)
{
    return {head_text(n), holds};
}

/// A value in SI, as the number is shown. Forces and stiffness of small walls get up to four
/// more decimals, two digits behind the zeros; anything smaller is rounding.
[[nodiscard]] inline Number number_cell(const WallNumber& n, double si)
{
    constexpr int kMore = 3;
    const double shown = si * n.unit.scale;
    const bool grows = n.unit.name == kForceUnit.name || n.unit.name == kStiffnessUnit.name;
    int decimals = n.decimals;
    if (grows && std::abs(shown) >= std::pow(10.0, -(n.decimals + kMore)))
        while (std::abs(shown) < std::pow(10.0, 1 - decimals)) ++decimals;
    return plain_number(shown, decimals);
}

/// @param holds with kCensored a bound gets a ">"
[[nodiscard]] inline Number number_cell(const WallNumber& n, const WallReading& wall,
                                        double height, unsigned holds = 0)
{
    Number cell = number_cell(n, n.reading(wall, height));
    const bool marked = (holds & kCensored) != 0 && n.is_bound != nullptr;
    if (marked && n.is_bound(wall)) cell.sense = Sense::above;
    return cell;
}

[[nodiscard]] inline Number number_cell(const WallNumber& n, const WallSource& wall,
                                        unsigned holds = 0)
{
    return n.fact != nullptr ? number_cell(n, n.fact(wall))
                             : number_cell(n, wall.reading, wall.height, holds);
}

/// @param source what the numbers of a row are taken from
template <class Of, class Source>
[[nodiscard]] TableColumn<Of> number_column(const WallNumber& n, unsigned holds, Source source)
{
    return {number_head(n, holds),
            [&n, holds, source](const Of& of) { return number_cell(n, source(of), holds); }};
}

/// Displacement and drift of a limit state.
/// @param limit, height of a row, the height that the drift is over [m]
template <class Of, class Limit, class Height>
[[nodiscard]] TableColumns<Of> limit_columns(Limit limit, Height height)
{
    return {{{"displacement [mm]", kCensored},
             [limit](const Of& of) { return limit_cell(limit(of), 1e3, 2); }},
            {{"drift [%]", kCensored}, [limit, height](const Of& of) {
                 return limit_cell(limit(of), fragility::percent_per_metre(height(of)), 3);
             }}};
}

} // namespace app
