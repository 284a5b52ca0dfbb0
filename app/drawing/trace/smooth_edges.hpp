#pragma once
/// Smooth edges of coloured areas. A program that scales a picture, or draws it without steps,
/// puts pixels of mixed colours between two areas; where the edge runs along the rows, many of
/// one colour that looks like a thin stone.

#include "app/drawing/trace/picture.hpp"

#include <cstddef>
#include <vector>

namespace app {

constexpr int kWidestEdge = 4; ///< of one colour [pixels]; what is wider anywhere is a stone

/// Marks the pixels that lie within squares of one kind, a pixel wider than edges are.
/// @param kind colour of each pixel as 0xRRGGBB, or kMortar
[[nodiscard]] std::vector<char> inner_pixels(const Labels& labels,
                                             const std::vector<int>& kind);

/// Whether a connected area of one kind is a smooth edge: most of its pixels lie across a
/// narrow band between two colours, and theirs is a mixture of the two. Programs mix the
/// numbers that are stored or the light that they stand for; where the mortar is thinner than a
/// pixel, black is in the mixture, too.
/// @param inner from inner_pixels()
/// @param area indices of its pixels
[[nodiscard]] bool is_smooth_edge(const Labels& labels, const std::vector<int>& kind,
                                  const std::vector<char>& inner,
                                  const std::vector<std::size_t>& area);

} // namespace app
