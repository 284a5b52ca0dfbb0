#include "tests/app/fragility/fragility_scenes.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/study_scenes.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace scenes {

app::DriftData drifts(const std::vector<std::vector<double>>& groups)
{
    app::DriftData data;
    data.source = "scene";
    data.drift = "Drift: given";
    data.group_head = "stress [MPa]";
    data.states = {{"ntc", "SLC", "drop to 80 % of the peak"}};
    data.options.bootstrap = 99;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double stress = 0.25 * static_cast<double>(g + 1);
        app::DriftGroup group{"group " + std::to_string(g), stress, {}, 0, 0, {}};
        for (const double d : groups[g])
            group.walls.push_back(
                {-1,
                 {std::signbit(d) ? fragility::right_censored(-d) : fragility::observed(d)}});
        data.groups.push_back(group);
    }
    return data;
}

app::StudyWalls study_walls(std::size_t n)
{
    app::StudyWalls walls;
    walls.name = "scene.h5";
    walls.study = study_scenes::study("samples = 8");
    walls.study.solver.kinematics = dem::Kinematics::small;
    walls.study.fragility.mode.modes = dem::ModeRule::paper;
    walls.rules = app::reading_rules(walls.study);
    walls.states = app::state_names(walls.rules);
    walls.inputs = {{"joint.friction_angle", "deg", 1.0, 0, 1, {}},
                    {"unit.tensile_strength", "MPa", 1.0, 1, 1, {}}};
    walls.height = 1.1;
    walls.step = 0.030 / static_cast<double>(app::kCurveSteps);
    for (const double stress : {0.5e6, 1.0e6}) {
        app::StudyLevel level{stress, {}, {}, 0};
        for (std::size_t i = 0; i < n; ++i) {
            app::StudyWall w;
            const double angle = 20.0 + 2.0 * static_cast<double>(i % 13);
            const bool mixed = angle < 32.0 || i % 7 == 3;
            w.key = {0, static_cast<std::uint32_t>(i)};
            w.reading.mode = mixed ? dem::FailureMode::mixed : dem::FailureMode::rocking;
            w.reading.dropped = mixed;
            w.mechanism.sliding_share = mixed ? 0.3 : 0.1;
            w.mechanism.rotation_share = 1.0 - w.mechanism.sliding_share;
            w.inputs = {angle, 3.0 + 0.1 * static_cast<double>(i % 5)};
            w.reading.peak = fragility::Peak{stress * 0.1 * (0.6 + 0.01 * angle), 0.01, false};
            const double at = mixed ? 0.015 + 0.0002 * static_cast<double>(i) : 0.028;
            w.reading.ultimate = {
                at, mixed ? fragility::Reading::observed : fragility::Reading::censored, ""};
            w.reading.limits.assign(walls.states.size(), w.reading.ultimate);
            w.forces.assign(app::kCurveSteps + 1, app::peak_force(w.reading));
            level.walls.push_back(w);
        }
        walls.levels.push_back(level);
    }
    return walls;
}

std::size_t column(const app::Table& t, const std::string& head)
{
    for (std::size_t c = 0; c < t.head.size(); ++c)
        if (t.head[c].name == head) return c;
    throw std::out_of_range("no column " + head);
}

std::string cell(const app::Table& t, std::size_t row, const std::string& head)
{
    return app::cell_text(t.rows.at(row).at(column(t, head)));
}

app::Number number_in(const app::Table& t, std::size_t row, const std::string& head)
{
    const auto* const n = std::get_if<app::Number>(&t.rows.at(row).at(column(t, head)));
    return n ? *n : app::Number{};
}

bool sound(const app::Table& t)
{
    for (const auto& row : t.rows) {
        if (row.size() != t.head.size()) return false;
        for (const app::Cell& cell : row) {
            std::string text = app::cell_text(cell);
            std::transform(text.begin(), text.end(), text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            for (const char* const bad : {"nan", "inf "})
                if (text.find(bad) != std::string::npos) return false;
        }
    }
    return true;
}

} // namespace scenes
