#pragma once
/// Where blocks and pieces of joint that are too short come from.

namespace app {

struct Masonry;
struct StudyFile;

/// Whether a wall in courses that has slivers would have none without its openings and their
/// lintels.
/// @param smallest length of a block or a piece of joint that is none [m]
[[nodiscard]] bool openings_make_slivers(Masonry masonry, const StudyFile& source,
                                         double smallest);

/// Whether a wall that has blocks below this length or height would have none if no unit could
/// crack.
/// @param smallest [m]
[[nodiscard]] bool cracks_make_slivers(const Masonry& masonry, const StudyFile& source,
                                       double smallest);

} // namespace app
