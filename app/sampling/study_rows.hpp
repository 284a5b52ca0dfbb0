#pragma once
/// Random inputs of a study whose values stand row by row: uq.together.

#include "uq/fields/spatial_sample.hpp"

#include <string_view>

namespace app {

struct Sampling;
struct StudyFile;
struct UqInput;

/// Whether uq.together names this key.
[[nodiscard]] bool is_together(const UqInput& uq, std::string_view key);

/// The rows of the inputs that uq.together names; none if it names none.
/// @throws ConfigError if it names fewer than two inputs, one that is not empirical(...) or
/// varies inside the wall, lists of different lengths, a value out of the range of its key, or
/// one that uq.pearson names, too
[[nodiscard]] uq::JointRows joint_rows(const Sampling& sampling, const StudyFile& source);

} // namespace app
