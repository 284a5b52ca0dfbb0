#pragma once
/// The event whose probability is sought, ready for the methods of uq/, and how its numbers are
/// shown.

#include "app/input/prepared_study.hpp"
#include "uq/reliability/reliability.hpp"

#include <string>
#include <vector>

namespace app {

struct ProgramInput;
struct RandomInput;
struct ReliabilityInput;
struct StudyFile;
struct UqInput;

/// From a study of walls.
/// @param level as level_of reads it
/// @throws ConfigError
[[nodiscard]] uq::ReliabilityProblem wall_problem(const PreparedStudy& ready,
                                                  const std::string& level, int threads);

/// From a study of another program (docs/external_program.md).
/// @throws ConfigError
[[nodiscard]] uq::ReliabilityProblem program_event(const Sampling& sampling,
                                                   const ProgramInput& input,
                                                   const ReliabilityInput& reliability,
                                                   const StudyFile& source, int threads);

/// The part that both kinds of study share, still without its event: dimension, method, budget
/// and seed.
/// @throws ConfigError if the budget is too small for the method, or the method cannot have
/// correlated inputs
[[nodiscard]] uq::ReliabilityProblem asked_problem(const UqInput& uq,
                                                   const ReliabilityInput& reliability,
                                                   const StudyFile& source,
                                                   Eigen::Index dimension);

/// A number of a sample as people read it: shown value = scale x value of the model.
struct ShownNumber {
    std::string name; ///< with its unit, where that is known: "joint.friction_angle [deg]"
    double scale = 1.0;
};

/// The inputs in the units of their keys; the variables of another program as they are.
/// @param names ReliabilityProblem::inputs
[[nodiscard]] std::vector<ShownNumber> shown_inputs(const ProgramInput& program,
                                                    const std::vector<RandomInput>& random,
                                                    const std::vector<std::string>& names);
/// The response, of a wall in the unit of its demand.
[[nodiscard]] ShownNumber shown_response(const ReliabilityInput& reliability,
                                         const ProgramInput& program,
                                         const uq::ReliabilityProblem& problem);

} // namespace app
