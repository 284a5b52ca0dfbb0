#pragma once
/// Studies whose walls lie in several random layouts: a layout is drawn by its seed alone, so
/// that any of them can be laid again by itself.

#include "dem/scene/wall.hpp"

#include <cstdint>

namespace app {

struct GeometryInput;
struct Masonry;
struct RandomInput;
struct StudyFile;
struct UqInput;

/// Whether the walls of a study differ in how their stones lie (wall.layouts).
[[nodiscard]] bool has_layouts(const GeometryInput& geometry);

/// Whether its samples differ in anything: in drawn values, or in their layouts.
[[nodiscard]] bool is_random(const GeometryInput& geometry,
                             const std::vector<RandomInput>& random);

/// Samples take the seeds wall.seed, wall.seed + 1, ... in turn, under every stress the same.
[[nodiscard]] std::uint32_t layout_seed(const Masonry& masonry, std::uint32_t sample);

/// Refuses keys that speak of single joints or units: they have no meaning across layouts.
/// @throws ConfigError
void check_layouts(const Masonry& masonry, const UqInput& uq, const StudyFile& source);

/// For verbs that take the wall of the study as it is. @throws ConfigError
void refuse_layouts(const GeometryInput& geometry, const StudyFile& source);

} // namespace app
