#pragma once
/// A value of a study that is random.

#include "app/input/study/parameters.hpp"
#include "uq/marginals/marginal.hpp"

#include <string>
#include <string_view>

namespace app {

/// A key whose value is a distribution.
struct RandomInput {
    std::string key;                ///< "joint.friction_angle"
    std::string_view unit;          ///< in which people read it: "deg"; empty: none
    ParameterPlace place = nullptr; ///< nullptr: a variable of another program
    uq::Marginal marginal;          ///< in SI, cut off at the range of the key
    double mean = 0.0;              ///< of the distribution as given, before that cut
    double cut = 0.0;               ///< probability outside that range before the cut [-]
    Varies varies = Varies::by_wall;
};

} // namespace app
