#pragma once
/// Layers of a drawing whose stone is not the wall's.

#include "app/drawing/outlines/drawing.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace app {

struct Study;

/// "NAME: rest"; without a name the whole text is the rest.
[[nodiscard]] std::pair<std::string, std::string_view> named_part(std::string_view text);

/// Reads wall.layer_stones, "NAME: E, Poisson's ratio, density; ...".
/// @throws BadValue
void parse_layer_stones(Study& study);

/// "; it has: lintel, sill": the layers of a drawing, for messages.
[[nodiscard]] std::string layers_text(const Drawing& drawing);

/// A note on how many stones each layer has, where there are several layers of the wall's own
/// stone: a layer of mortar or ground that is shown is one of stones. Else empty.
/// @param others layers of another stone
[[nodiscard]] std::string layers_note(const Drawing& drawing,
                                      const std::vector<std::string>& others);

} // namespace app
