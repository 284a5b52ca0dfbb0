#pragma once
/// Layers that a drawing program does not show are no part of the wall.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace app {

/// Outlines and other shapes that were passed over.
struct HiddenShapes {
    std::map<std::string, std::size_t> on_layers; ///< how many on each layer that is hidden
    std::size_t alone = 0;                        ///< hidden themselves
};

/// "1 hidden layer (infill) with 2 shapes was ignored."
void note_hidden(RawDrawing& drawing, const HiddenShapes& hidden);

} // namespace app
