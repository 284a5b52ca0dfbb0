#pragma once
/// Sites in square cells, so that only what is near is compared.

#include "dem/scene/geometry/polygon.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace dem {

/// Cells as many as sites. The sites themselves stay where they are, in a list that every
/// question brings along.
class SiteGrid {
  public:
    /// @param extent of the sites
    /// @param n number of sites, >= 1
    SiteGrid(const Region& extent, std::size_t n);

    [[nodiscard]] double side() const { return side_; } ///< of a cell [m]

    /// @param index of the site in the list
    void add(Point site, std::size_t index);

    /// Distance of the nearest site that was added [m]; infinite without sites.
    [[nodiscard]] double nearest(Point at, const std::vector<Point>& sites) const;

    /// Distances [m] and indices of the sites further than `from` and at most `to` away, the
    /// nearest first.
    /// @param self the site from which they are measured; it is none of them
    [[nodiscard]] std::vector<std::pair<double, std::size_t>>
    between(double from, double to, std::size_t self, const std::vector<Point>& sites) const;

  private:
    [[nodiscard]] int place(double distance) const;
    [[nodiscard]] int column(Point p) const;
    [[nodiscard]] int row(Point p) const;
    [[nodiscard]] std::size_t cell(int c, int r) const;

    Region extent_;
    double side_;
    int columns_, rows_;
    std::vector<std::vector<std::size_t>> cells_;
};

} // namespace dem
