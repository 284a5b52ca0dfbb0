#include "app/report/report_film.hpp"

#include "app/report/report_bytes.hpp"
#include "app/text/json_text.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace app {
namespace {

constexpr double kDamageStep = 1.0 / 255.0; ///< of damage and crushing

/// In the order of dem::FaceKind.
constexpr std::array kKindNames = {"bed", "head", "crack", "beam", "base"};
static_assert(kKindNames.size() == static_cast<std::size_t>(dem::FaceKind::base_joint) + 1);

using Corners = MotionFit::Corners;
using Weights = MotionFit::Weights;

std::size_t nearest_point(const std::vector<dem::Point>& outline, double x, double z)
{
    const auto away = [&](dem::Point p) { return std::hypot(p.x - x, p.z - z); };
    const auto nearest = std::ranges::min_element(
        outline, [&](dem::Point p, dem::Point q) { return away(p) < away(q); });
    return static_cast<std::size_t>(nearest - outline.begin());
}

Corners corners_of(const std::vector<dem::Point>& outline)
{
    if (outline.empty()) throw std::invalid_argument("a block without outline");
    const auto [left, right] = std::ranges::minmax_element(
        outline, [](dem::Point p, dem::Point q) { return p.x < q.x; });
    const auto [low, high] = std::ranges::minmax_element(
        outline, [](dem::Point p, dem::Point q) { return p.z < q.z; });
    return {nearest_point(outline, left->x, low->z), nearest_point(outline, right->x, low->z),
            nearest_point(outline, left->x, high->z),
            nearest_point(outline, right->x, high->z)};
}

bool is_rectangle(const std::vector<dem::Point>& outline, const Corners& at)
{
    const dem::Point low = outline[at.lower_left], high = outline[at.upper_right];
    const double box = (high.x - low.x) * (high.z - low.z);
    constexpr double kRounding = 1e-6;
    return std::abs(dem::polygon_area(outline) - box) <= kRounding * box;
}

/// Least squares over all points of an outline that is not a rectangle.
Weights weights_of(const std::vector<dem::Point>& outline)
{
    const auto [left, right] = std::ranges::minmax(outline, {}, &dem::Point::x);
    const auto [low, high] = std::ranges::minmax(outline, {}, &dem::Point::z);
    const auto n = static_cast<double>(outline.size());
    std::vector<dem::Point> at; // (xi, zeta)
    dem::Point mean;
    for (const dem::Point p : outline) {
        at.push_back({(2.0 * p.x - left.x - right.x) / (right.x - left.x),
                      (2.0 * p.z - low.z - high.z) / (high.z - low.z)});
        mean = {mean.x + at.back().x / n, mean.z + at.back().z / n};
    }
    double xx = 0.0, xz = 0.0, zz = 0.0;
    for (dem::Point& q : at) {
        q = {q.x - mean.x, q.z - mean.z};
        xx += q.x * q.x;
        xz += q.x * q.z;
        zz += q.z * q.z;
    }
    const double det = xx * zz - xz * xz;
    if (!(det > 0.0)) throw std::invalid_argument("an outline without area");
    Weights w;
    for (const dem::Point q : at) {
        w.b.push_back((zz * q.x - xz * q.z) / det);
        w.c.push_back((xx * q.z - xz * q.x) / det);
        w.a.push_back(1.0 / n - mean.x * w.b.back() - mean.z * w.c.back());
    }
    return w;
}

BlockMotion motion_of(const std::vector<dem::Point>& displacement, const Corners& at)
{
    const dem::Point ll = displacement.at(at.lower_left), rl = displacement.at(at.lower_right),
                     lh = displacement.at(at.upper_left), rh = displacement.at(at.upper_right);
    const auto combine = [&](double sll, double srl, double slh) {
        return dem::Point{0.25 * (sll * ll.x + srl * rl.x + slh * lh.x + rh.x),
                          0.25 * (sll * ll.z + srl * rl.z + slh * lh.z + rh.z)};
    };
    return {combine(1, 1, 1), combine(-1, 1, -1), combine(-1, -1, 1)};
}

double mean_damage(const dem::FaceState& face)
{
    double damage = 0.0, area = 0.0;
    for (const dem::ContactState& c : face.contacts) {
        damage += c.damage * c.area;
        area += c.area;
    }
    return area > 0.0 ? damage / area : 0.0;
}

/// One series over the frames for each crack.
std::vector<double> damages(std::span<const dem::Snapshot> frames)
{
    std::vector<double> series;
    for (std::size_t f = 0; f < frames.front().faces.size(); ++f) {
        if (frames.front().faces[f].kind != dem::FaceKind::unit_crack) continue;
        for (const dem::Snapshot& s : frames) series.push_back(mean_damage(s.faces[f]));
    }
    return series;
}

/// State of crushing of the contacts in one half of a face: whether one has begun to crush, and
/// how far the worst has come.
double worst_crushing(std::span<const dem::ContactState> half)
{
    double worst = 0.0;
    for (const dem::ContactState& c : half)
        if (c.crushed > 0.0) worst = std::max({worst, c.crushing, kDamageStep});
    return worst;
}

/// Two series over the frames for each face.
std::vector<double> crushings(std::span<const dem::Snapshot> frames)
{
    std::vector<double> series;
    for (std::size_t f = 0; f < frames.front().faces.size(); ++f) {
        const std::size_t n = frames.front().faces[f].contacts.size(), middle = (n + 1) / 2;
        for (const bool first : {true, false})
            for (const dem::Snapshot& s : frames) {
                const std::span all(s.faces[f].contacts);
                series.push_back(worst_crushing(first ? all.first(middle) : all.last(middle)));
            }
    }
    return series;
}

/// Six series over the frames for each block.
std::vector<double> motions(std::span<const dem::Snapshot> frames)
{
    const std::size_t n = frames.size(), blocks = frames.front().blocks.size();
    std::vector<double> series(6 * blocks * n);
    for (std::size_t b = 0; b < blocks; ++b) {
        const MotionFit fit(frames.front().blocks[b].outline);
        for (std::size_t t = 0; t < n; ++t) {
            const BlockMotion m = fit.motion(frames[t].blocks[b].displacement);
            const std::array<double, 6> values = {m.a.x, m.a.z, m.b.x, m.b.z, m.c.x, m.c.z};
            for (std::size_t k = 0; k < 6; ++k) series[(k * blocks + b) * n + t] = values[k];
        }
    }
    return series;
}

void append(std::vector<std::uint8_t>& all, const std::vector<std::uint8_t>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

Json wall_geometry(const dem::Layout& layout)
{
    Json blocks = Json::array(), faces = Json::array();
    for (const dem::Block& b : layout.blocks) {
        Json block = {b.x0, b.z0, b.x1, b.z1, b.course, b.unit};
        if (!b.outline.empty()) {
            Json corners = Json::array();
            for (const dem::Point p : b.outline) corners.push_back({p.x, p.z});
            block.push_back(corners);
        }
        blocks.push_back(block);
    }
    for (const dem::Face& f : layout.faces) {
        const char* const kind = kKindNames.at(static_cast<std::size_t>(f.kind));
        Json face = {kind, f.id, f.a, f.b, f.from.x, f.from.z, f.to.x, f.to.z};
        const bool level = f.normal.x == 0.0 && f.normal.z == 1.0;
        if (!level && !(f.normal.x == 1.0 && f.normal.z == 0.0)) {
            face.push_back(f.normal.x);
            face.push_back(f.normal.z);
        }
        faces.push_back(face);
    }
    return {{"blocks", blocks}, {"faces", faces}};
}

MotionFit::MotionFit(const std::vector<dem::Point>& outline) : at_(corners_of(outline))
{
    if (!is_rectangle(outline, at_)) weights_ = weights_of(outline);
}

BlockMotion MotionFit::motion(const std::vector<dem::Point>& displacement) const
{
    if (weights_.a.empty()) return motion_of(displacement, at_);
    const auto sum = [&](const std::vector<double>& weights) {
        dem::Point total;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const dem::Point u = displacement.at(i);
            total = {total.x + weights[i] * u.x, total.z + weights[i] * u.z};
        }
        return total;
    };
    return {sum(weights_.a), sum(weights_.b), sum(weights_.c)};
}

Film film_of(std::span<const dem::Snapshot> frames)
{
    if (frames.empty()) throw std::invalid_argument("a film needs a frame");
    Film film;
    film.frames = static_cast<int>(frames.size());
    const std::vector<double> moved = motions(frames);
    std::vector<double> drive;
    for (const dem::Snapshot& s : frames) drive.push_back(s.displacement);
    film.step =
        std::max(kFilmStep, std::max(largest_size(moved), largest_size(drive)) / 32000.0);
    std::vector<std::uint8_t> bytes = differences(drive, frames.size(), film.step, 2);
    append(bytes, differences(moved, frames.size(), film.step, 2));
    append(bytes, differences(damages(frames), frames.size(), kDamageStep, 1));
    const std::vector<double> crushed = crushings(frames);
    film.crushing = largest_size(crushed) > 0.0;
    if (film.crushing) append(bytes, differences(crushed, frames.size(), kDamageStep, 1));
    film.data = base64(deflated(bytes));
    return film;
}

} // namespace app
