#pragma once
/// Walls of a study whose samples lie in layouts of their own: those of one layout are pushed
/// together.

#include "app/input/prepared_study.hpp"
#include "app/study/pushed/push_walls.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace app {

/// The sample of wall i of a list.
using SampleOf = std::function<std::uint32_t(std::size_t i)>;

/// As push_walls, of walls each in the layout of its sample. A layout that makes no wall is the
/// failure of its walls.
/// @param list a closed one
void push_in_layouts(const PreparedStudy& ready, const dem::PushPlan& plan,
                     const PushList& list, const SampleOf& sample, int threads);

} // namespace app
