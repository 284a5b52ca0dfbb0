#pragma once
/// The identity of the evaluations of a reliability analysis: a text of all that their values
/// depend on. Evaluations that an interrupted run has left serve an analysis with the same
/// text.

#include <string>

namespace app {

struct Study;

/// Identity of the study, rules of reading and vertical stress, however they were written.
/// Method, budget and demand are not among them.
[[nodiscard]] std::string wall_evaluations(const Study& study, const std::string& level);

/// Keys and names of the variables of another program.
[[nodiscard]] std::string program_evaluations(const Study& study);

} // namespace app
