#pragma once
/// An elevation's terms of the masonry quality index, MQI = SM (SD + SS + WC + HJ + VJ + MM) of
/// Borri, Corradi, Castori, De Maria (2015), Bull. Earthquake Eng. 13:2647. Limits of SD and
/// VJ: its Tables 2 and 6, as transcribed in rapidMQI (G. Castellazzi, University of Bologna);
/// VJ there is of a trace between points about 1 m apart, at least 0.5 m. Stone (SM), leaves
/// (WC) and mortar (MM) cannot be seen in an elevation; shape (SS) and level beds (HJ) are
/// judged by eye there and measured here.

#include "dem/scene/bond_indices.hpp"

namespace dem {

enum class Fulfilled { no, partly, fully };

struct QualityTerms {
    double long_stones =
        0.0; ///< share of units longer than 400 mm, by the larger side of their extent [-]
    double middle_stones = 0.0; ///< share of units of 200 to 400 mm [-]
    /// SD: by the class that more than half belong to; of no such class: partly.
    Fulfilled dimensions = Fulfilled::no;
    Fulfilled staggered =
        Fulfilled::no; ///< VJ of one leaf: trace above 1.6, or from 1.4 times the height
    double filled =
        0.0; ///< for SS: area of the units over that of their extents [-], 1 of rectangles
};

/// @param indices of the layout
/// @param layout whose blocks are whole units, at least one
[[nodiscard]] QualityTerms quality_terms(const BondIndices& indices, const Layout& layout);

} // namespace dem
