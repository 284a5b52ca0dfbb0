#include "app/drawing/outlines/plane_grid.hpp"

#include "dem/scene/geometry/polygon.hpp"

namespace app {

PlaneGrid::PlaneGrid(std::span<const dem::Point> points)
{
    if (points.empty()) return;
    const dem::Region e = dem::extent_of(points);
    low_ = {e.x0, e.z0};
    const double width = e.x1 - e.x0, height = e.z1 - e.z0, longer = std::max(width, height);
    if (longer <= 0.0) return;
    const double n = static_cast<double>(points.size());
    size_ = std::max(std::sqrt(width * height / n), longer / std::min(n + 1.0, 4096.0));
    columns_ = static_cast<std::size_t>(width / size_) + 1;
    rows_ = static_cast<std::size_t>(height / size_) + 1;
}

std::pair<std::size_t, std::size_t> PlaneGrid::rows_of(dem::Point a, dem::Point b,
                                                       double margin, std::size_t column) const
{
    const double slack = margin + 1e-6 * size_; // a cell's edge is not met to the last bit
    const double left = low_.x + static_cast<double>(column) * size_ - slack;
    const auto height = [&](double x) {
        const double share = b.x > a.x ? std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : 0.0;
        return a.z + share * (b.z - a.z);
    };
    double one = height(left), other = height(left + size_ + 2.0 * slack);
    if (!(b.x > a.x)) one = a.z, other = b.z;
    return {row(std::min(one, other) - slack), row(std::max(one, other) + slack)};
}

CellLists::CellLists(std::size_t cells, std::span<const std::pair<std::size_t, int>> entries)
    : begin_(cells + 1), items_(entries.size())
{
    for (const auto& [cell, item] : entries) ++begin_[cell + 1];
    for (std::size_t cell = 0; cell < cells; ++cell) begin_[cell + 1] += begin_[cell];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& [cell, item] : entries) items_[next[cell]++] = item;
}

} // namespace app
