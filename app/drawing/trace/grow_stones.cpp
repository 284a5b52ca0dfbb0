#include "app/drawing/trace/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace app {
namespace {

constexpr int kFar = std::numeric_limits<int>::max();

/// The nearest stone pixel in the same column.
struct InColumn {
    std::vector<int> distance, label; ///< [pixels]; kFar where the column has no stone
};

InColumn nearest_in_column(const Labels& labels)
{
    InColumn nearest{std::vector<int>(labels.label.size(), kFar), labels.label};
    const auto pass = [&](int row, int from) {
        for (int column = 0; column < labels.columns; ++column) {
            const std::size_t p = labels.pixel(column, row), q = labels.pixel(column, from);
            if (nearest.distance[q] == kFar || nearest.distance[q] + 1 >= nearest.distance[p])
                continue;
            nearest.distance[p] = nearest.distance[q] + 1;
            nearest.label[p] = nearest.label[q];
        }
    };
    for (std::size_t p = 0; p < labels.label.size(); ++p)
        if (labels.label[p] != kMortar) nearest.distance[p] = 0;
    for (int row = 1; row < labels.rows; ++row) pass(row, row - 1);
    for (int row = labels.rows - 2; row >= 0; --row) pass(row, row + 1);
    return nearest;
}

/// One parabola of the lower envelope over a row.
struct Parabola {
    int column = 0;
    double height = 0.0; ///< squared distance at its own column [m2]
    double from = 0.0;   ///< where it begins to be the lowest [columns]
};

/// The label of the nearest stone pixel for each pixel of a row: the lower envelope of the
/// parabolas of all columns (Felzenszwalb and Huttenlocher 2012, Theory of Computing 8,
/// 415-428). Of two equally near the left one.
void grow_row(Labels& labels, const InColumn& nearest, PixelSize size, int row,
              std::vector<Parabola>& envelope)
{
    const double w2 = size.width * size.width, h2 = size.height * size.height;
    envelope.clear();
    for (int column = 0; column < labels.columns; ++column) {
        const int distance = nearest.distance[labels.pixel(column, row)];
        if (distance == kFar) continue;
        Parabola next{column, h2 * distance * distance, -1.0};
        while (!envelope.empty()) {
            const Parabola& last = envelope.back();
            const double c = next.column, d = last.column;
            next.from =
                (next.height - last.height + w2 * (c * c - d * d)) / (2.0 * w2 * (c - d));
            if (next.from > last.from) break;
            envelope.pop_back();
            next.from = -1.0;
        }
        envelope.push_back(next);
    }
    std::size_t k = 0;
    for (int column = 0; column < labels.columns; ++column) {
        while (k + 1 < envelope.size() && envelope[k + 1].from < column) ++k;
        labels.label[labels.pixel(column, row)] =
            nearest.label[labels.pixel(envelope[k].column, row)];
    }
}

/// The largest connected piece of each stone stays; the others become mortar.
void keep_largest_pieces(Labels& labels)
{
    std::vector<char> seen(labels.label.size());
    std::vector<std::vector<std::size_t>> largest(static_cast<std::size_t>(labels.stones));
    for (std::size_t first = 0; first < labels.label.size(); ++first) {
        if (seen[first] || labels.label[first] == kMortar) continue;
        std::vector<std::size_t> piece = connected(labels, labels.label, first, seen);
        std::vector<std::size_t>& best = largest[labels.label[first]];
        if (best.size() < piece.size()) best.swap(piece);
    }
    std::ranges::fill(labels.label, kMortar);
    for (int stone = 0; stone < labels.stones; ++stone)
        for (const std::size_t p : largest[stone]) labels.label[p] = stone;
}

/// Mortar is taken pixel by pixel by the stones beside it.
void fill_mortar(Labels& labels)
{
    std::vector<std::size_t> queue;
    for (std::size_t p = 0; p < labels.label.size(); ++p) {
        if (labels.label[p] == kMortar) continue;
        bool beside = false;
        visit_neighbours(labels, p,
                         [&](std::size_t q) { beside |= labels.label[q] == kMortar; });
        if (beside) queue.push_back(p);
    }
    for (std::size_t k = 0; k < queue.size(); ++k)
        visit_neighbours(labels, queue[k], [&](std::size_t q) {
            if (labels.label[q] != kMortar) return;
            labels.label[q] = labels.label[queue[k]];
            queue.push_back(q);
        });
}

} // namespace

std::vector<std::size_t> connected(const Labels& labels, const std::vector<int>& kind,
                                   std::size_t first, std::vector<char>& seen)
{
    std::vector<std::size_t> piece{first};
    seen[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k)
        visit_neighbours(labels, piece[k], [&](std::size_t p) {
            if (seen[p] || kind[p] != kind[first]) return;
            seen[p] = 1;
            piece.push_back(p);
        });
    return piece;
}

Painted painted_stones(const Labels& labels)
{
    Painted painted{labels.columns, labels.rows, std::vector<char>(labels.label.size())};
    for (std::size_t p = 0; p < labels.label.size(); ++p)
        painted.stone[p] = labels.label[p] != kMortar ? 1 : 0;
    return painted;
}

double distance_to_stone(const Painted& painted, PixelSize pixel, dem::Point at)
{
    const double column = at.x / pixel.width, row = painted.rows - at.z / pixel.height;
    const int x = static_cast<int>(std::lround(column)), y = static_cast<int>(std::lround(row));
    const int most = std::max(painted.columns, painted.rows);
    const double side = std::min(pixel.width, pixel.height);
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](int c, int r) {
        if (c < 0 || r < 0 || c >= painted.columns || r >= painted.rows) return;
        const std::size_t p = static_cast<std::size_t>(r) * painted.columns + c;
        if (!painted.stone[p]) return;
        const double dx = std::max({c - column, column - c - 1.0, 0.0}) * pixel.width,
                     dz = std::max({r - row, row - r - 1.0, 0.0}) * pixel.height;
        least = std::min(least, std::hypot(dx, dz));
    };
    // squares around the corner of the pixels, each larger by a pixel
    for (int k = 1; k <= most && (k - 2) * side < least; ++k) {
        for (int c = x - k; c < x + k; ++c) {
            look(c, y - k);
            look(c, y + k - 1);
        }
        for (int r = y - k + 1; r < y + k - 1; ++r) {
            look(x - k, r);
            look(x + k - 1, r);
        }
    }
    return least;
}

Labels grow_stones(Labels labels, PixelSize size)
{
    const std::vector<int> before = labels.label;
    const auto in_opening = [&](std::size_t p) {
        return before[p] != kMortar && labels.is_opening[before[p]] != 0;
    };
    for (std::size_t p = 0; p < before.size(); ++p)
        if (in_opening(p)) labels.label[p] = kMortar;
    const InColumn nearest = nearest_in_column(labels);
    std::vector<Parabola> envelope;
    for (int row = 0; row < labels.rows; ++row) grow_row(labels, nearest, size, row, envelope);
    for (std::size_t p = 0; p < before.size(); ++p)
        if (in_opening(p)) labels.label[p] = before[p];
    // cells of pixels can have tips that hang by the corner of a pixel
    keep_largest_pieces(labels);
    fill_mortar(labels);
    return labels;
}

} // namespace app
