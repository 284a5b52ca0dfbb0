#pragma once
/// Square cells over the plane, so that only what is near is compared.

#include "dem/scene/geometry/snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace app {

class PlaneGrid {
  public:
    /// About as many cells as points.
    explicit PlaneGrid(std::span<const dem::Point> points);

    [[nodiscard]] std::size_t cells() const { return columns_ * rows_; }
    [[nodiscard]] std::size_t cell_of(dem::Point p) const
    {
        return column(p.x) * rows_ + row(p.z);
    }

    /// Calls visit(cell) for the cells within `margin` of the segment from a to b, and for few
    /// more.
    template <class Visit>
    void visit_segment(dem::Point a, dem::Point b, double margin, const Visit& visit) const
    {
        if (a.x > b.x) std::swap(a, b);
        const std::size_t last = column(b.x + margin);
        for (std::size_t c = column(a.x - margin); c <= last; ++c) {
            const auto [low, high] = rows_of(a, b, margin, c);
            for (std::size_t r = low; r <= high; ++r) visit(c * rows_ + r);
        }
    }

  private:
    [[nodiscard]] std::size_t column(double x) const { return index(x - low_.x, columns_); }
    [[nodiscard]] std::size_t row(double z) const { return index(z - low_.z, rows_); }
    [[nodiscard]] std::size_t index(double distance, std::size_t n) const
    {
        return static_cast<std::size_t>(
            std::clamp(distance / size_, 0.0, static_cast<double>(n - 1)));
    }
    /// First and last row that the segment, a left of b, reaches in a column.
    [[nodiscard]] std::pair<std::size_t, std::size_t>
    rows_of(dem::Point a, dem::Point b, double margin, std::size_t column) const;

    dem::Point low_;
    double size_ = 1.0;
    std::size_t columns_ = 1, rows_ = 1;
};

/// Things sorted into the cells of a grid.
class CellLists {
  public:
    /// @param entries cell and thing; things keep their order within a cell
    CellLists(std::size_t cells, std::span<const std::pair<std::size_t, int>> entries);

    [[nodiscard]] std::span<const int> operator[](std::size_t cell) const
    {
        return std::span(items_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
    }
    [[nodiscard]] std::size_t cells() const { return begin_.size() - 1; }

  private:
    std::vector<std::size_t> begin_;
    std::vector<int> items_;
};

} // namespace app
