#pragma once
/// A mesh in space whose faces, or whose front, are blocks of a flat wall.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <array>
#include <string>
#include <vector>

namespace app {

struct SpaceMesh {
    std::vector<std::array<double, 3>> points; ///< x, y, z in the drawing's unit
    std::vector<std::vector<int>> faces;       ///< indices of points
    std::string layer;
    int line = 0; ///< of the file, from 1
};

/// A flat mesh in the x-z or the x-y plane: each face is a block. A prism along y, or else
/// along z: its front is one block. All meshes of a file are taken the same way, and the
/// drawing's notes say which.
/// @throws ConfigError if a mesh is neither
void add_meshes(RawDrawing& drawing, const std::vector<SpaceMesh>& meshes, double snap);

} // namespace app
