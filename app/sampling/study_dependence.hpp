#pragma once
/// Random inputs of a study by name, and their correlation: uq.pearson.

#include "uq/designs/normal_copula.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace app {

struct RandomInput;
struct Sampling;
struct StudyFile;

/// Place in Study::random of the input with this name.
/// @param key that names it: "uq.pearson"
/// @throws ConfigError where there is none
[[nodiscard]] std::size_t input_named(const std::vector<RandomInput>& random,
                                      const StudyFile& source, std::string_view word,
                                      const char* key);

/// The dependence of the inputs through the normal copula; nothing if all are independent.
/// @throws ConfigError if uq.pearson names something that is not a random input, or asks for a
/// correlation that cannot be had; in a spatial study also if it joins inputs that do not vary
/// over the same joints
[[nodiscard]] std::optional<uq::NormalCopula> dependence_of(const Sampling& sampling,
                                                            const StudyFile& source);

} // namespace app
