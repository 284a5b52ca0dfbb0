#pragma once
/// How often a mode of failure occurs. Every output reads its shares here, so that all have one
/// interval.

#include "app/study/stored/study_walls.hpp"
#include "core/binomial.hpp"
#include "fragility/fits/share.hpp"

namespace app {

/// Share of a mode, or of kAllModes, among the walls of a stress. The interval holds the
/// probability whatever the failed walls would have been, and whatever those that still stood
/// (WallReading::mode_so_far) would become.
/// @param confidence in (0, 1)
[[nodiscard]] fragility::Share
mode_share(const StudyLevel& level, int mode, double confidence,
           core::BinomialInterval kind = core::BinomialInterval::wilson);

} // namespace app
