#include "bench/validation/mechanisms.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_marks.hpp"
#include "app/push/push_until_told.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace bench {
namespace {

constexpr double kCell = 300.0, kHead = 64.0; // [px]

/// The wall nearest the mean of its mode.
const app::StudyWall* typical(const app::StudyLevel& level, int mode)
{
    double sum = 0.0;
    std::size_t n = 0;
    for (const app::StudyWall& w : level.walls)
        if (app::mode_of(w) == mode) sum += app::peak_force(w.reading), ++n;
    if (n == 0) return nullptr;
    const double mean = sum / static_cast<double>(n);
    const app::StudyWall* nearest = nullptr;
    const auto off = [&](const app::StudyWall& w) {
        return std::abs(app::peak_force(w.reading) - mean);
    };
    for (const app::StudyWall& w : level.walls)
        if (app::mode_of(w) == mode && (nearest == nullptr || off(w) < off(*nearest)))
            nearest = &w;
    return nearest;
}

/// The wall in a cell, displacements as they are times a round number.
std::string draw(const dem::Snapshot& wall, app::Pixel corner)
{
    const app::WallBox rest = app::box_of(wall.blocks, 0.0);
    app::WallView view;
    view.scale = app::drawing_scale(wall);
    view.mark_size = 0.5;
    const app::WallBox box = app::join(rest, app::box_of(wall.blocks, view.scale));
    view.pixels_per_metre = std::min((kCell - 30.0) / (box.high.x - box.low.x),
                                     (kCell - 40.0) / (box.high.z - box.low.z));
    view.origin = {corner.x + 15.0 - box.low.x * view.pixels_per_metre,
                   corner.y + kCell - 10.0};
    app::MarkSizes marks;
    for (const dem::FaceState& f : wall.faces)
        for (const dem::ContactState& c : f.contacts)
            marks.widest_slip = std::max(marks.widest_slip, std::abs(c.slip));
    return app::draw_undeformed(wall, view) + app::draw_blocks(wall, view) +
           app::draw_openings(wall, view, marks) + app::draw_slips(wall, view, marks) +
           app::draw_cracks(wall, view);
}

} // namespace

app::NamedPicture mechanisms(const std::filesystem::path& file, const app::StudyWalls& walls)
{
    const app::StudySource source = app::study_source(file.string(), {});
    constexpr std::array kModes = {app::kRocking, app::kMixed};
    std::vector<app::WantedWall> wanted;
    std::vector<app::Pixel> corners;
    std::string text;
    for (std::size_t l = 0; l < walls.levels.size(); ++l)
        for (const int mode : kModes) {
            const app::StudyWall* const w = typical(walls.levels[l], mode);
            if (w == nullptr) continue;
            const std::string stress = app::fixed(walls.levels[l].stress * 1e-6, 2) + " MPa";
            const auto chosen = app::wanted_walls(
                source, {.sample = static_cast<int>(w->key.sample), .level = stress});
            wanted.insert(wanted.end(), chosen.begin(), chosen.end());
            corners.push_back(
                {static_cast<double>(l) * kCell, kHead + (mode == app::kMixed ? kCell : 0.0)});
            text += app::svg_text({corners.back().x + 15.0, corners.back().y + 14.0},
                                  stress + ", " + app::mode_name(mode) + ", wall " +
                                      std::to_string(w->key.sample),
                                  "font-size=\"12\"");
        }
    const app::Pushed pushed =
        app::push_until_told(source.ready, app::push_plan(source.ready.study), wanted, 0, true);
    const std::string title = "Mechanisms at the end of the push, by mode and stress";
    std::string body = app::svg_text({15.0, 26.0}, title, "font-weight=\"bold\"") +
                       app::svg_text({15.0, 46.0},
                                     "For each mode the wall whose peak is nearest the mean: "
                                     "blue open joints, orange slip, red cracks; movements "
                                     "are drawn larger",
                                     "font-size=\"12\"") +
                       text;
    for (std::size_t i = 0; i < pushed.walls.size(); ++i)
        body += draw(pushed.walls[i].result.at_end, corners[i]);
    const double width = kCell * static_cast<double>(walls.levels.size());
    return {"fig11_mechanisms", title,
            app::svg_page(width, kHead + 2.0 * kCell + 10.0, title, body)};
}

} // namespace bench
