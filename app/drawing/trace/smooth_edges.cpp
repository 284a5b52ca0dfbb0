#include "app/drawing/trace/smooth_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace app {
namespace {

constexpr int kReach = 8;           // from an edge to the colours that it lies between [pixels]
constexpr double kRounding = 4.0;   // of a mixed colour, of 255
constexpr double kToldApart = 16;   // between two colours whose mixture can be told, of 255
constexpr double kOvershoot = 0.1;  // of the contrast, of programs that sharpen
constexpr double kMixedShare = 0.8; // of the pixels of an edge

/// Red, green and blue, in [0, 255] as stored or in [0, 1] as light.
using Rgb = std::array<double, 3>;

Rgb stored(int kind)
{
    if (kind == kMortar) return {};
    return {static_cast<double>(kind >> 16 & 0xff), static_cast<double>(kind >> 8 & 0xff),
            static_cast<double>(kind & 0xff)};
}

/// The transfer function of sRGB (IEC 61966-2-1), both ways.
Rgb light(Rgb c)
{
    for (double& x : c) {
        x /= 255.0;
        x = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    return c;
}
Rgb stored(Rgb light)
{
    for (double& x : light)
        x = 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
    return light;
}

double dot(const Rgb& a, const Rgb& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rgb difference(const Rgb& a, const Rgb& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double apart(const Rgb& a, const Rgb& b)
{
    const Rgb d = difference(a, b);
    return std::sqrt(dot(d, d));
}
Rgb sum(const Rgb& a, double s, const Rgb& b)
{
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// The mixture of two colours that is nearest to c.
Rgb mixture(const Rgb& c, const Rgb& a, const Rgb& b)
{
    const Rgb way = difference(b, a);
    const double square = dot(way, way);
    const double t =
        square > 0.0 ? std::clamp(dot(difference(c, a), way) / square, 0.0, 1.0) : 0.0;
    return sum(a, t, way);
}

/// The mixture of two colours and of black that is nearest to c.
Rgb mixture_with_black(const Rgb& c, const Rgb& a, const Rgb& b)
{
    const double aa = dot(a, a), bb = dot(b, b), ab = dot(a, b), det = aa * bb - ab * ab;
    if (det > 1e-9 * aa * bb) {
        const double p = (dot(c, a) * bb - dot(c, b) * ab) / det,
                     q = (dot(c, b) * aa - dot(c, a) * ab) / det;
        if (p >= 0.0 && q >= 0.0 && p + q <= 1.0) return sum(sum({}, p, a), q, b);
    }
    const std::array sides = {mixture(c, {}, a), mixture(c, {}, b), mixture(c, a, b)};
    return *std::ranges::min_element(sides, {}, [&](const Rgb& m) { return apart(m, c); });
}

/// Whether a colour is a mixture of others, of the numbers stored or of the light.
template <class Mix> bool is_mixed(int c, int a, int b, Mix mix)
{
    const Rgb x = stored(c), y = stored(a), z = stored(b);
    return apart(mix(x, y, z), x) <= kRounding ||
           apart(stored(mix(light(x), light(y), light(z))), x) <= kRounding;
}

bool differ(int a, int b) { return apart(stored(a), stored(b)) >= kToldApart; }

/// Whether c lies between the colours of areas beside it, or beyond one of them by as much as
/// programs that sharpen make it.
bool is_between_areas(int c, int a, int b)
{
    const bool stones = a != kMortar && b != kMortar;
    if (stones && (differ(a, b) || differ(a, c)) && is_mixed(c, a, b, mixture_with_black))
        return true;
    if (!differ(a, b)) return false;
    const double beyond = kOvershoot * apart(stored(a), stored(b));
    if (std::min(apart(stored(c), stored(a)), apart(stored(c), stored(b))) <= beyond)
        return true;
    return is_mixed(c, a, b, mixture);
}

/// A pixel and the kinds around it.
struct Around {
    const Labels& labels;
    const std::vector<int>& kind;
    const std::vector<char>& inner;
    int column = 0, row = 0;

    /// Nothing outside of the picture.
    [[nodiscard]] std::optional<std::size_t> pixel(int right, int down, int steps) const
    {
        const int c = column + right * steps, r = row + down * steps;
        if (c < 0 || r < 0 || c >= labels.columns || r >= labels.rows) return {};
        return labels.pixel(c, r);
    }
};

/// The way from a pixel out of its area.
struct Way {
    int run = 0;  ///< pixels to the first of another kind
    int next = 0; ///< that kind
    std::optional<int>
        area; ///< kind of the first mortar, or pixel inside an area, within kReach
};

std::optional<Way> way_out(const Around& at, int right, int down)
{
    const int own = at.kind[*at.pixel(right, down, 0)];
    Way way;
    for (int steps = 1; steps <= kReach; ++steps) {
        const std::optional<std::size_t> p = at.pixel(right, down, steps);
        const int kind = p ? at.kind[*p] : kMortar;
        if (way.run == 0 && kind == own) {
            if (steps == kWidestEdge) return {};
            continue;
        }
        if (way.run == 0) {
            way.run = steps;
            way.next = kind;
        }
        if (kind == kMortar || at.inner[*p]) { // where there is no pixel there is mortar
            way.area = kind;
            break;
        }
    }
    if (way.run == 0) return {};
    return way;
}

/// Whether the colour of a pixel lies between those on both sides, across a band that is
/// narrow.
bool is_mixed_pixel(const Around& at)
{
    const std::size_t p = *at.pixel(0, 0, 0);
    if (at.inner[p]) return false;
    for (const auto& [right, down] : {std::array{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
        const std::optional<Way> one = way_out(at, right, down);
        if (!one) continue;
        const std::optional<Way> other = way_out(at, -right, -down);
        if (!other || one->run + other->run - 1 > kWidestEdge) continue;
        if (differ(one->next, other->next) &&
            is_mixed(at.kind[p], one->next, other->next, mixture))
            return true;
        if (one->area && other->area && is_between_areas(at.kind[p], *one->area, *other->area))
            return true;
    }
    return false;
}

} // namespace

std::vector<char> inner_pixels(const Labels& labels, const std::vector<int>& kind)
{
    constexpr int kSide = kWidestEdge + 1; // of a square of one kind [pixels]
    std::vector<char> inner(kind.size());
    const auto columns = static_cast<std::size_t>(labels.columns);
    std::vector<int> above(columns), here(columns); // sides of squares that end at each pixel
    for (std::size_t p = 0; p < kind.size(); ++p) {
        const std::size_t c = p % columns;
        if (c == 0) above.swap(here);
        const bool grows = c > 0 && p >= columns && kind[p - 1] == kind[p] &&
                           kind[p - columns] == kind[p] && kind[p - columns - 1] == kind[p];
        here[c] =
            grows ? std::min(kSide, 1 + std::min({here[c - 1], above[c], above[c - 1]})) : 1;
        inner[p] = here[c] == kSide ? 1 : 0;
    }
    // from the last pixel of each square to all of it
    std::vector<int> left(columns);
    int to_go = 0;
    for (std::size_t p = kind.size(); p-- > 0;) {
        const std::size_t c = p % columns;
        if (c + 1 == columns) to_go = 0;
        to_go = inner[p] ? kSide : std::max(0, to_go - 1);
        left[c] = to_go > 0 ? kSide : std::max(0, left[c] - 1);
        inner[p] = left[c] > 0 ? 1 : 0;
    }
    return inner;
}

bool is_smooth_edge(const Labels& labels, const std::vector<int>& kind,
                    const std::vector<char>& inner, const std::vector<std::size_t>& area)
{
    const double most = (1.0 - kMixedShare) * static_cast<double>(area.size());
    double others = 0.0;
    for (const std::size_t p : area) {
        const auto at = static_cast<int>(p);
        if (is_mixed_pixel({labels, kind, inner, at % labels.columns, at / labels.columns}))
            continue;
        if (++others > most) return false;
    }
    return true;
}

} // namespace app
