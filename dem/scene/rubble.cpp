#include "dem/scene/rubble.hpp"

#include "dem/scene/crack_pattern.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

constexpr double kShortestSide = 0.1; // of the smaller size of a stone

/// Corners of cells; those of neighbours are one.
class Corners {
  public:
    std::size_t number_of(Point p)
    {
        const auto cell = [](double x) { return std::llround(x / kSame); };
        for (auto x = cell(p.x) - 1; x <= cell(p.x) + 1; ++x)
            for (auto z = cell(p.z) - 1; z <= cell(p.z) + 1; ++z)
                if (const auto at = numbers_.find({x, z}); at != numbers_.end())
                    return at->second;
        numbers_[{cell(p.x), cell(p.z)}] = points.size();
        points.push_back(p);
        return points.size() - 1;
    }

    std::vector<Point> points;

  private:
    static constexpr double kSame = 1e-7; // [m]
    std::map<std::pair<long long, long long>, std::size_t> numbers_;
};

/// Corners that become one, and where that lies.
class Groups {
  public:
    explicit Groups(const std::vector<Point>& corners) : head_(corners.size())
    {
        for (std::size_t k = 0; k < head_.size(); ++k) head_[k] = k;
    }
    std::size_t head_of(std::size_t k)
    {
        while (head_[k] != k) k = head_[k] = head_[head_[k]];
        return k;
    }
    void join(std::size_t a, std::size_t b)
    {
        a = head_of(a);
        b = head_of(b);
        head_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> head_;
};

using Cell = std::vector<std::size_t>; ///< numbers of its corners

/// The middle of the corners of each group; on the border of the wall where one of them lies
/// there.
std::vector<Point> places_of(const Rubble& wall, const std::vector<Point>& corners,
                             Groups& groups)
{
    constexpr double kOnBorder = 1e-7; // [m]
    const auto middle = [&](double Point::*axis, double end) {
        std::vector<double> sum(corners.size(), 0.0), border(corners.size(), NAN);
        std::vector<int> n(corners.size(), 0);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t g = groups.head_of(k);
            const double x = corners[k].*axis;
            sum[g] += x;
            ++n[g];
            if (x < kOnBorder) border[g] = 0.0;
            if (x > end - kOnBorder) border[g] = end;
        }
        for (std::size_t g = 0; g < corners.size(); ++g)
            sum[g] = std::isnan(border[g]) ? sum[g] / std::max(n[g], 1) : border[g];
        return sum;
    };
    const std::vector<double> x = middle(&Point::x, wall.length),
                              z = middle(&Point::z, wall.height);
    std::vector<Point> places;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t g = groups.head_of(k);
        places.push_back({x[g], z[g]});
    }
    return places;
}

std::vector<Outline> without_short_sides(const Rubble& wall, const std::vector<Outline>& all)
{
    const double shortest = kShortestSide * std::min(wall.stone_length, wall.stone_height);
    Corners corners;
    std::vector<Cell> cells;
    for (const Outline& outline : all) {
        cells.emplace_back();
        for (const Point p : outline) cells.back().push_back(corners.number_of(p));
    }
    Groups groups(corners.points);
    for (const Cell& cell : cells)
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const std::size_t a = cell[i], b = cell[(i + 1) % cell.size()];
            const Point p = corners.points[a], q = corners.points[b];
            if (std::hypot(q.x - p.x, q.z - p.z) < shortest) groups.join(a, b);
        }
    const std::vector<Point> places = places_of(wall, corners.points, groups);
    std::vector<Outline> left;
    for (Cell& cell : cells) {
        for (std::size_t& k : cell) k = groups.head_of(k);
        cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
        while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
        Outline outline;
        for (const std::size_t k : cell) outline.push_back(places[k]);
        if (outline.size() >= 3 && polygon_area(outline) > 0.0)
            left.push_back(std::move(outline));
    }
    return left;
}

} // namespace

std::vector<Outline> rubble(const Rubble& wall)
{
    if (!(wall.length > 0.0 && wall.height > 0.0 && wall.stone_length > 0.0 &&
          wall.stone_height > 0.0))
        throw std::invalid_argument("a wall of rubble needs positive sizes");
    const double stretch = wall.stone_length / wall.stone_height, top = stretch * wall.height;
    const CrackPattern cells{CrackPattern::Kind::voronoi, 1, 1, wall.stone_length};
    std::vector<Outline> stones =
        pieces_of({{0.0, 0.0}, {wall.length, 0.0}, {wall.length, top}, {0.0, top}}, cells, 0.0,
                  wall.seed);
    for (Outline& stone : stones)
        for (Point& p : stone) p.z /= stretch;
    return without_short_sides(wall, stones);
}

} // namespace dem
