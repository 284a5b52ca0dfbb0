#include "app/drawing/trace/border_chains.hpp"

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

namespace app {
namespace {

constexpr std::array<int, 4> kRight = {1, 0, -1, 0},
                             kDown = {0, 1, 0, -1}; // east, south, west, north

/// The corners of the pixels, (columns + 1) x (rows + 1) of them, and the borders between them.
struct CornerGrid {
    const Labels& labels;
    double width, height; ///< of the picture [m]
    std::vector<std::uint8_t> walked;

    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(labels.columns + 1) +
               static_cast<std::size_t>(x);
    }

    /// Labels on the left and on the right of the step from (x, y) in a direction, as the
    /// picture is seen.
    [[nodiscard]] std::pair<int, int> beside(int x, int y, int direction) const
    {
        switch (direction) {
        case 0:
            return {labels.at(x, y - 1), labels.at(x, y)};
        case 1:
            return {labels.at(x, y), labels.at(x - 1, y)};
        case 2:
            return {labels.at(x - 1, y), labels.at(x - 1, y - 1)};
        default:
            return {labels.at(x - 1, y - 1), labels.at(x, y - 1)};
        }
    }

    [[nodiscard]] bool border(int x, int y, int direction) const
    {
        const auto [left, right] = beside(x, y, direction);
        return left != right;
    }

    [[nodiscard]] bool junction(int x, int y) const
    {
        int n = 0;
        for (int d = 0; d < 4; ++d) n += border(x, y, d) ? 1 : 0;
        const bool corner = (x == 0 || x == labels.columns) && (y == 0 || y == labels.rows);
        return corner || n > 2;
    }

    [[nodiscard]] dem::Point position(int x, int y) const
    {
        const double right = x == labels.columns ? width : width * x / labels.columns;
        const double up = y == 0 ? height : height * (labels.rows - y) / labels.rows;
        return {right, up};
    }
};

/// Walks from a junction to the next one.
Chain walk(CornerGrid& grid, const std::vector<int>& junction_at, int x, int y, int direction)
{
    Chain chain;
    chain.from = junction_at[grid.index(x, y)];
    std::tie(chain.left, chain.right) = grid.beside(x, y, direction);
    chain.points.push_back(grid.position(x, y));
    while (true) {
        grid.walked[grid.index(x, y)] |= static_cast<std::uint8_t>(1 << direction);
        x += kRight[direction];
        y += kDown[direction];
        const int back = (direction + 2) % 4;
        grid.walked[grid.index(x, y)] |= static_cast<std::uint8_t>(1 << back);
        chain.points.push_back(grid.position(x, y));
        chain.to = junction_at[grid.index(x, y)];
        if (chain.to >= 0) return chain;
        for (const int next : {direction, (direction + 1) % 4, (direction + 3) % 4}) {
            if (!grid.border(x, y, next)) continue;
            direction = next;
            break;
        }
    }
}

/// A border that meets no junction is a stone around another.
void refuse_islands(const DrawingFrame& frame, const CornerGrid& grid)
{
    for (int y = 0; y <= grid.labels.rows; ++y)
        for (int x = 0; x <= grid.labels.columns; ++x)
            for (int d = 0; d < 4; ++d) {
                if (!grid.border(x, y, d) || (grid.walked[grid.index(x, y)] & (1 << d)) != 0)
                    continue;
                refuse(frame, 0,
                       "one stone encloses another at pixel (" + std::to_string(x) + ", " +
                           std::to_string(y) +
                           "); paint both alike, or divide the outer one by mortar");
            }
}

} // namespace

ChainNetwork trace_borders(const DrawingFrame& frame, const Labels& labels, double width,
                           double height)
{
    CornerGrid grid{labels, width, height, {}};
    const std::size_t corners = grid.index(labels.columns, labels.rows) + 1;
    grid.walked.assign(corners, 0);
    std::vector<int> junction_at(corners, -1);
    ChainNetwork network;
    std::vector<std::pair<int, int>> pixels;
    for (int y = 0; y <= labels.rows; ++y)
        for (int x = 0; x <= labels.columns; ++x) {
            if (!grid.junction(x, y)) continue;
            junction_at[grid.index(x, y)] = static_cast<int>(pixels.size());
            pixels.emplace_back(x, y);
            const bool on_frame = x == 0 || y == 0 || x == labels.columns || y == labels.rows;
            network.junctions.push_back({grid.position(x, y), on_frame});
        }
    for (const auto& [x, y] : pixels)
        for (int d = 0; d < 4; ++d)
            if (grid.border(x, y, d) && (grid.walked[grid.index(x, y)] & (1 << d)) == 0)
                network.chains.push_back(walk(grid, junction_at, x, y, d));
    refuse_islands(frame, grid);
    return network;
}

} // namespace app
