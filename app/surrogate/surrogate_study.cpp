#include "app/sampling/study_dependence.hpp"
#include "app/surrogate/surrogate_output.hpp"

namespace app {

SurrogateStudy surrogate_study(const StudyWalls& walls, const WallNumber& response,
                               std::size_t most)
{
    SurrogateStudy s{&walls, &response, surrogate_inputs(walls), {}, {}};
    std::vector<uq::PolynomialFamily> families;
    for (const std::size_t k : s.inputs)
        families.push_back(uq::family_of(*walls.inputs[k].marginal));
    const bool dependent = dependence_of(walls.study, walls.study.source).has_value() ||
                           !walls.study.uq.together.empty();
    for (std::size_t level = 0; level < walls.levels.size(); ++level) {
        s.levels.push_back(
            fit_surrogate(surrogate_points(walls, level, s.inputs, response, most), families,
                          dependent, walls.study.uq.seed));
        s.modes.push_back(fit_mode_surrogate(mode_points(walls, level, s.inputs, most)));
    }
    return s;
}

} // namespace app
