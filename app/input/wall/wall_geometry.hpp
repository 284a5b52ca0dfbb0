#pragma once
/// The blocks and joints of a study's wall: courses by their keys, or outlines that were drawn.

#include "dem/scene/layout.hpp"
#include "dem/scene/wall.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct GeometryInput;
struct JointInput;
struct Masonry;
struct Parameters;
struct Study;
struct StudyFile;

/// Reads the outlines of `wall.geometry` or `wall.outlines` into the study, and what follows
/// from them.
/// @throws ConfigError at the drawing, or at a key of the study
void read_geometry(Study& study);

/// A block without joints has nothing to move by.
/// @throws ConfigError
void require_joints(const GeometryInput& geometry, const StudyFile& source,
                    const dem::Layout& layout);

/// Whether the study brings outlines of its own.
[[nodiscard]] bool is_drawn(const GeometryInput& geometry);

/// Whether its keys say so; it need not be read any further.
[[nodiscard]] bool in_courses(const GeometryInput& geometry);

/// The key that draws the wall; "wall" of one that its other keys build.
[[nodiscard]] std::string_view geometry_key(const GeometryInput& geometry);

[[nodiscard]] double wall_length(const Masonry& masonry); ///< [m]
[[nodiscard]] double
wall_height(const Masonry& masonry); ///< above the floor, without the beam [m]

/// Extent of the masonry, without the beam.
[[nodiscard]] dem::Region wall_extent(const Masonry& masonry);

/// Whether joints are bonded: their mean strength is not zero.
[[nodiscard]] bool has_mortar(const JointInput& joint);

/// The first key by which cracks follow the law of mixed modes; empty: they follow that of the
/// paper.
/// @param units_crack has_cracks() of the study
[[nodiscard]] std::string_view mixed_mode_key(const Parameters& p, bool units_crack);

/// Whether anything can crush: a mean strength is given.
/// @param units_crack has_cracks() of the study
[[nodiscard]] bool has_crushing(const Parameters& p, bool units_crack);

/// Whether the masonry fills the rectangle around it with stones of one density.
[[nodiscard]] bool is_full_rectangle(const Masonry& masonry);

/// Layout of the wall with its beam. prepare() has it at hand (app/input/prepared_study.hpp).
[[nodiscard]] dem::Layout layout_of(const Masonry& masonry, const StudyFile& source);

/// Its blocks and faces, before anything is said of the laws that these follow.
[[nodiscard]] dem::Layout laid_units(const Masonry& masonry, const StudyFile& source);

/// The same if no unit could crack.
[[nodiscard]] dem::Layout whole_units(Masonry masonry, const StudyFile& source);

/// "0 0, 0.2 0, 0.2 0.1, 0 0.1; ...": corners in metres, to all digits, counter-clockwise. A
/// layer that is not the wall's own stone stands in front: "lintel: 0 0, ...".
[[nodiscard]] std::string outlines_text(const GeometryInput& geometry);

/// A short text that differs where outlines do.
[[nodiscard]] std::string outlines_mark(const GeometryInput& geometry);

} // namespace app
