#pragma once
/// Effects of each change of a choice on a wall, as a table and as a tornado picture.

#include "app/choices/choice_list.hpp"
#include "app/output/table/table.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// A change and the wall that came of it; without a wall where it did not apply or the wall
/// failed.
struct ChoiceResult {
    std::string key, before, after;
    std::string reason; ///< why there is no wall; empty: there is one
    std::optional<WallReading> reading;
    double height = 1.0; ///< of the load [m], > 0
};

/// @param base the wall as the study has it
[[nodiscard]] Table choice_results(const ChoiceResult& base,
                                   const std::vector<ChoiceResult>& all);

/// Relative changes of the peak force and of the drift limit [-], the largest first. A limit
/// that was not reached is a lower bound.
struct Tornado {
    struct Bar {
        std::string label;
        double change = 0.0;
        bool at_least = false;
    };
    std::vector<Bar> peak, limit;
};
[[nodiscard]] Tornado tornado(const ChoiceResult& base, const std::vector<ChoiceResult>& all);

/// SVG of both, beside each other.
[[nodiscard]] std::string tornado_svg(const Tornado& tornado, const std::string& title);

} // namespace app
