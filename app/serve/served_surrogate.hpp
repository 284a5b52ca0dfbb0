#pragma once
/// A surrogate of walls as models of UM-Bridge.

#include "app/serve/umbridge.hpp"
#include "app/surrogate/learned_surrogate.hpp"

#include <memory>
#include <string>
#include <vector>

namespace app {

/// Under each vertical stress that has a surrogate the model NAME_surrogate: inputs in SI in,
/// as those of the walls; response, its standard deviation and the number of inputs outside the
/// data out. NAME is that of the walls' model.
/// @throws ConfigError if no stress has one
[[nodiscard]] std::vector<ServedModel>
surrogate_models(const std::shared_ptr<const LearnedSurrogate>& surrogate);

/// Lines for people: stresses without a surrogate, and those whose surrogate is not to be
/// trusted.
[[nodiscard]] std::string surrogate_doubts(const LearnedSurrogate& surrogate);

} // namespace app
