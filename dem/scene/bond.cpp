#include "dem/scene/bond.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace dem {

namespace {

bool is_shifted(const WallGeometry& wall, int course)
{
    return (course % 2 == 0) == (wall.first_course == FirstCourse::whole);
}

/// x of the ends of the units where one follows the other from `start` on, both ends of the
/// wall included.
std::vector<double> ends_of_equal_units(const WallGeometry& wall, double start)
{
    std::vector<double> x{0.0};
    if (start > kSmallestPiece && start < wall.length - kSmallestPiece) x.push_back(start);
    for (int i = 1; start + i * wall.unit_length < wall.length - kSmallestPiece; ++i)
        x.push_back(start + i * wall.unit_length);
    x.push_back(wall.length);
    return x;
}

/// Units by turns, the first of which begins at `start`, at or left of the wall.
struct Row {
    double start;
    std::vector<double> lengths;
};

Row row_of(const WallGeometry& wall, bool shifted)
{
    const double whole = wall.unit_length, header = wall.header_length;
    if (wall.bond == Bond::flemish) // headers above the middles of whole units
        return {shifted ? -0.5 * (whole + header) : 0.0, {whole, header}};
    if (wall.bond == Bond::english && !shifted) return {0.0, {whole}};
    return {shifted ? -0.5 * header : 0.0, {header}};
}

std::vector<double> ends_of_row(const WallGeometry& wall, const Row& row)
{
    std::vector<double> x{0.0};
    double at = row.start;
    for (std::size_t i = 0; at < wall.length - kSmallestPiece; ++i) {
        if (at > kSmallestPiece) x.push_back(at);
        at += row.lengths[i % row.lengths.size()];
    }
    x.push_back(wall.length);
    return x;
}

/// A piece shorter than a header at an end of a course changes places with the header beside
/// it: masons lay such a closer behind the header of the corner.
void move_closers(const WallGeometry& wall, std::vector<double>& x)
{
    const auto closes = [&](double piece, double beside) {
        return piece < wall.header_length - kSmallestPiece &&
               std::abs(beside - wall.header_length) < kSmallestPiece;
    };
    const std::size_t n = x.size() - 1; // pieces
    if (n < 3) return;
    if (closes(x[1] - x[0], x[2] - x[1])) x[1] = x[0] + (x[2] - x[1]);
    if (closes(x[n] - x[n - 1], x[n - 1] - x[n - 2])) x[n - 1] = x[n] - (x[n - 1] - x[n - 2]);
}

/// As the bond has them.
std::vector<double> regular_ends(const WallGeometry& wall, int course)
{
    const bool shifted = is_shifted(wall, course);
    if (wall.bond == Bond::shifted)
        return ends_of_equal_units(wall, shifted ? wall.bond_offset * wall.unit_length : 0.0);
    std::vector<double> x = ends_of_row(wall, row_of(wall, shifted));
    if (wall.bond != Bond::header) move_closers(wall, x);
    return x;
}

/// How far a head joint moves at most [m]: a length between two joints that move evenly within
/// it has a variance of two thirds of its square.
double most_move(const WallGeometry& wall)
{
    return std::sqrt(1.5) * wall.length_cov * wall.unit_length;
}

/// Keyed by course and joint, so that a longer or higher wall has the same joints.
void move_joints(const WallGeometry& wall, int course, std::vector<double>& x)
{
    std::seed_seq key{wall.seed, static_cast<unsigned>(course)};
    std::mt19937_64 bits(key);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double uniform = static_cast<double>(bits() >> 11U) * 0x1p-53;
        x[i] += most_move(wall) * (2.0 * uniform - 1.0);
    }
}

} // namespace

std::vector<CoursePiece> bonded_course(const WallGeometry& wall, int course)
{
    const std::vector<double> regular = regular_ends(wall, course);
    std::vector<double> x = regular;
    if (wall.length_cov > 0.0) move_joints(wall, course, x);
    std::vector<CoursePiece> pieces;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        pieces.push_back(
            {x[i], x[i + 1], regular[i + 1] - regular[i] > wall.unit_length - kSmallestPiece});
    return pieces;
}

void join_slivers(std::vector<CoursePiece>& pieces)
{
    const auto meet = [](double a, double b) { return std::abs(a - b) < kSmallestPiece; };
    for (std::size_t i = 0; i < pieces.size();) {
        const CoursePiece p = pieces[i];
        const bool sliver = p.material == 0 && p.x1 - p.x0 < kShortestUnit;
        const bool left =
            sliver && i > 0 && pieces[i - 1].material == 0 && meet(pieces[i - 1].x1, p.x0);
        const bool right = sliver && !left && i + 1 < pieces.size() &&
                           pieces[i + 1].material == 0 && meet(pieces[i + 1].x0, p.x1);
        if (left) pieces[i - 1].x1 = p.x1;
        if (right) pieces[i + 1].x0 = p.x0;
        if (left || right)
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

double top_of_course(const WallGeometry& wall, int course)
{
    if (wall.course_heights.empty()) return course * wall.course_height;
    double top = 0.0;
    for (int c = 0; c < course; ++c) top += wall.course_heights[static_cast<std::size_t>(c)];
    return top;
}

double most_length_cov(const WallGeometry& wall)
{
    double least = wall.unit_length;
    const std::vector<double> one = regular_ends(wall, 1), two = regular_ends(wall, 2);
    for (const std::vector<double>& x : {one, two})
        for (std::size_t i = 0; i + 1 < x.size(); ++i) least = std::min(least, x[i + 1] - x[i]);
    if (wall.courses > 1)
        for (std::size_t i = 1, j = 1; i + 1 < one.size() && j + 1 < two.size();) {
            least = std::min(least, std::abs(one[i] - two[j]));
            ++(one[i] < two[j] ? i : j);
        }
    return std::max(0.0, 0.5 * (least - kShortestUnit)) / (std::sqrt(1.5) * wall.unit_length);
}

} // namespace dem
