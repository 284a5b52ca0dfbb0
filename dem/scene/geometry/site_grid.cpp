#include "dem/scene/geometry/site_grid.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

double length(Point a, Point b) { return std::hypot(a.x - b.x, a.z - b.z); }

} // namespace

SiteGrid::SiteGrid(const Region& e, std::size_t n)
    : extent_(e), side_(std::sqrt((e.x1 - e.x0) * (e.z1 - e.z0) / static_cast<double>(n))),
      columns_(place(e.x1 - e.x0) + 1), rows_(place(e.z1 - e.z0) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
{
}

void SiteGrid::add(Point site, std::size_t index)
{
    cells_[cell(column(site), row(site))].push_back(index);
}

double SiteGrid::nearest(Point at, const std::vector<Point>& sites) const
{
    double least = INFINITY;
    const int c0 = column(at), r0 = row(at), most = std::max(columns_, rows_);
    const auto look = [&](int c, int r) {
        if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return;
        for (const std::size_t i : cells_[cell(c, r)])
            least = std::min(least, length(at, sites[i]));
    };
    for (int k = 0; k <= most && least > (k - 1) * side_; ++k) { // rings of cells
        for (int c = c0 - k; c <= c0 + k; ++c) {
            look(c, r0 - k);
            if (k > 0) look(c, r0 + k);
        }
        for (int r = r0 - k + 1; r < r0 + k; ++r) {
            look(c0 - k, r);
            look(c0 + k, r);
        }
    }
    return least;
}

std::vector<std::pair<double, std::size_t>>
SiteGrid::between(double from, double to, std::size_t self,
                  const std::vector<Point>& sites) const
{
    std::vector<std::pair<double, std::size_t>> found;
    const Point at = sites[self];
    const Point low{at.x - to, at.z - to}, high{at.x + to, at.z + to};
    for (int r = row(low); r <= row(high); ++r)
        for (int c = column(low); c <= column(high); ++c)
            for (const std::size_t i : cells_[cell(c, r)]) {
                const double d = length(sites[i], at);
                if (i != self && d > from && d <= to) found.emplace_back(d, i);
            }
    std::ranges::sort(found);
    return found;
}

int SiteGrid::place(double distance) const
{
    return static_cast<int>(std::clamp(distance / side_, 0.0, 1e6));
}

int SiteGrid::column(Point p) const { return std::min(place(p.x - extent_.x0), columns_ - 1); }

int SiteGrid::row(Point p) const { return std::min(place(p.z - extent_.z0), rows_ - 1); }

std::size_t SiteGrid::cell(int c, int r) const
{
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c);
}

} // namespace dem
