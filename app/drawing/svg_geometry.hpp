#pragma once
/// Geometry in the attributes of SVG elements: transforms, points and paths. y points
/// downwards.

#include "app/drawing/outlines/raw_drawing.hpp"
#include "app/drawing/plane_transform.hpp"

#include <string_view>
#include <vector>

namespace app {

/// A point of SVG, y downwards.
struct SvgPoint {
    double x = 0.0, y = 0.0;
};
[[nodiscard]] SvgPoint apply(const PlaneTransform& t, SvgPoint p);

/// Where an attribute stands, for messages.
struct SvgPlace {
    const DrawingFrame* frame = nullptr;
    int line = 0;
};

/// "translate(1, 2) rotate(30)". @throws ConfigError
[[nodiscard]] PlaneTransform svg_transform(const SvgPlace& place, std::string_view text);

/// "0,0 1,0 1,1". @throws ConfigError
[[nodiscard]] std::vector<SvgPoint> svg_points(const SvgPlace& place, std::string_view text);

struct SvgSubpath {
    std::vector<SvgPoint> points;
    bool closed = false; ///< by Z
};

/// "M 0 0 h 1 v 1 z m ...". Bezier curves whose control points are within a thousandth of the
/// chord are straight sides.
/// @throws ConfigError for other curves, with the point where they begin
[[nodiscard]] std::vector<SvgSubpath> svg_path(const SvgPlace& place, std::string_view text);

/// A length without unit, or in px. @throws ConfigError
[[nodiscard]] double svg_length(const SvgPlace& place, std::string_view name,
                                std::string_view text);

} // namespace app
