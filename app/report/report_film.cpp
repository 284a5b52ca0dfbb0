#include "app/report/report_film.hpp"

#include "app/report/report_bytes.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

const char* kind_name(dem::FaceKind kind)
{
    switch (kind) {
    case dem::FaceKind::bed_joint:
        return "bed";
    case dem::FaceKind::head_joint:
        return "head";
    case dem::FaceKind::unit_crack:
        return "crack";
    case dem::FaceKind::beam_joint:
        return "beam";
    case dem::FaceKind::base_joint:
        break;
    }
    return "base";
}

/// Places in an outline of the points nearest to the corners of its box.
struct Corners {
    std::size_t lower_left, lower_right, upper_left, upper_right;
};

std::size_t nearest_point(const std::vector<dem::Point>& outline, double x, double z)
{
    const auto away = [&](dem::Point p) { return std::hypot(p.x - x, p.z - z); };
    const auto nearest =
        std::min_element(outline.begin(), outline.end(),
                         [&](dem::Point p, dem::Point q) { return away(p) < away(q); });
    return static_cast<std::size_t>(nearest - outline.begin());
}

Corners corners_of(const std::vector<dem::Point>& outline)
{
    if (outline.empty()) throw std::invalid_argument("a block without outline");
    const auto [left, right] = std::minmax_element(
        outline.begin(), outline.end(), [](dem::Point p, dem::Point q) { return p.x < q.x; });
    const auto [low, high] = std::minmax_element(
        outline.begin(), outline.end(), [](dem::Point p, dem::Point q) { return p.z < q.z; });
    return {nearest_point(outline, left->x, low->z), nearest_point(outline, right->x, low->z),
            nearest_point(outline, left->x, high->z),
            nearest_point(outline, right->x, high->z)};
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

/// Six series over the frames for each block.
std::vector<double> motions(std::span<const dem::Snapshot> frames)
{
    const std::size_t n = frames.size(), blocks = frames.front().blocks.size();
    std::vector<double> series(6 * blocks * n);
    for (std::size_t b = 0; b < blocks; ++b) {
        const Corners corners = corners_of(frames.front().blocks[b].outline);
        for (std::size_t t = 0; t < n; ++t) {
            const BlockMotion m = motion_of(frames[t].blocks[b].displacement, corners);
            const std::array<double, 6> values = {m.a.x, m.a.z, m.b.x, m.b.z, m.c.x, m.c.z};
            for (std::size_t k = 0; k < 6; ++k) series[(k * blocks + b) * n + t] = values[k];
        }
    }
    return series;
}

double largest(const std::vector<double>& series)
{
    double most = 0.0;
    for (const double u : series)
        if (std::isfinite(u)) most = std::max(most, std::abs(u));
    return most;
}

void append(std::vector<std::uint8_t>& all, const std::vector<std::uint8_t>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

Json wall_geometry(const dem::Layout& layout)
{
    Json blocks = Json::array(), faces = Json::array();
    for (const dem::Block& b : layout.blocks)
        blocks.push_back({b.x0, b.z0, b.x1, b.z1, b.course, b.unit});
    for (const dem::Face& f : layout.faces)
        faces.push_back(
            {kind_name(f.kind), f.id, f.a, f.b, f.from.x, f.from.z, f.to.x, f.to.z});
    return {{"blocks", blocks}, {"faces", faces}};
}

BlockMotion block_motion(const dem::BlockState& block)
{
    return motion_of(block.displacement, corners_of(block.outline));
}

Film film_of(std::span<const dem::Snapshot> frames)
{
    if (frames.empty()) throw std::invalid_argument("a film needs a frame");
    Film film;
    film.frames = static_cast<int>(frames.size());
    const std::vector<double> moved = motions(frames);
    std::vector<double> drive;
    for (const dem::Snapshot& s : frames) drive.push_back(s.displacement);
    film.step = std::max(kFilmStep, std::max(largest(moved), largest(drive)) / 32000.0);
    std::vector<std::uint8_t> bytes = differences(drive, frames.size(), film.step, 2);
    append(bytes, differences(moved, frames.size(), film.step, 2));
    append(bytes, differences(damages(frames), frames.size(), 1.0 / 255.0, 1));
    film.data = base64(deflated(bytes));
    return film;
}

} // namespace app
