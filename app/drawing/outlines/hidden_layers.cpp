#include "app/drawing/outlines/hidden_layers.hpp"

namespace app {

void note_hidden(RawDrawing& drawing, const HiddenShapes& hidden)
{
    std::string names;
    std::size_t shapes = 0;
    for (const auto& [name, n] : hidden.on_layers) {
        names += (names.empty() ? "" : ", ") + (name.empty() ? "without a name" : name);
        shapes += n;
    }
    const std::size_t layers = hidden.on_layers.size();
    if (layers > 0) {
        drawing.notes.push_back(counted(layers, "hidden layer", "hidden layers") + " (" +
                                names + ") with " + counted(shapes, "shape", "shapes") +
                                (layers == 1 ? " was" : " were") + " ignored.");
    }
    if (hidden.alone > 0) {
        drawing.notes.push_back(
            counted(hidden.alone, "hidden shape was", "hidden shapes were") + " ignored.");
    }
}

} // namespace app
