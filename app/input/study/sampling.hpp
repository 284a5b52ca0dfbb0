#pragma once
/// Inputs of a study that are random, and how they are sampled.

#include "app/input/study/random_input.hpp"
#include "app/input/study/uq_input.hpp"

#include <vector>

namespace app {

struct Sampling {
    UqInput uq;
    std::vector<RandomInput> random; ///< in the order of the keys; the fields hold their means
};

} // namespace app
