#pragma once
/// A study file written for people: each line says whose value it is.

#include "app/new/new_answers.hpp"

#include <string>

namespace app {

/// The text of a study of the wall of these answers, which must be checked (new_answers.hpp).
/// @param path of the file that it is written to, for the commands in its head
[[nodiscard]] std::string new_study_text(const Answers& answers, const std::string& path);

} // namespace app
