#include "try/wasm/page_json.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/verb.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "fragility/curve/limit_states.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/limits/fragility_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace page {
namespace {

using app::Json;

constexpr app::Verb kPush{.name = "push", .sections = app::kWallSections};

constexpr std::array kKinds = {"number", "list", "count", "word", "text"};

Json point_list(const std::vector<dem::Point>& points)
{
    Json list = Json::array();
    for (const dem::Point p : points) {
        list.push_back(app::rounded(p.x, 7));
        list.push_back(app::rounded(p.z, 7));
    }
    return list;
}

std::vector<dem::Point> outline_of(const dem::Block& b)
{
    if (!b.outline.empty()) return b.outline;
    return {{b.x0, b.z0}, {b.x1, b.z0}, {b.x1, b.z1}, {b.x0, b.z1}};
}

/// Number of the corner of an outline that is nearest.
std::size_t corner_at(const std::vector<dem::Point>& outline, dem::Point at)
{
    const auto distance = [&](dem::Point p) { return std::hypot(p.x - at.x, p.z - at.z); };
    return std::ranges::min_element(outline, {}, distance) - outline.begin();
}

/// Percent.
double drift(const fragility::LimitDisplacement& limit, double height)
{
    return 100.0 * limit.displacement / height;
}

} // namespace

Json keys_json()
{
    const app::Study defaults;
    Json all = Json::array();
    for (const app::Key& key : app::study_keys()) {
        if (!app::reads(kPush, key)) continue;
        Json words = Json::array();
        for (const app::Named& n : key.names) words.push_back(n.word);
        Json j = {{"name", key.name},
                  {"kind", kKinds[static_cast<int>(key.kind)]},
                  {"unit", key.unit},
                  {"words", words},
                  {"default", key.example.empty() ? app::value_text(key, defaults) : ""},
                  {"required", !key.example.empty()},
                  {"example", key.example},
                  {"allowed", app::allowed_values(key)},
                  {"meaning", key.meaning}};
        const bool number = key.kind != app::Kind::word && key.kind != app::Kind::text;
        if (number) {
            j["low"] = key.range.low;
            j["high"] = key.range.high;
        }
        all.push_back(std::move(j));
    }
    return all;
}

Json scene_json(const app::PreparedStudy& ready)
{
    const app::Study& study = ready.study;
    const dem::Layout& layout = ready.layout;
    Json blocks = Json::array(), cracks = Json::array();
    for (std::size_t b = 0; b < layout.blocks.size(); ++b)
        blocks.push_back({{"outline", point_list(outline_of(layout.blocks[b]))},
                          {"unit", layout.blocks[b].unit},
                          {"course", layout.blocks[b].course}});
    for (const dem::Face& f : layout.faces)
        if (f.kind == dem::FaceKind::unit_crack) cracks.push_back(point_list({f.from, f.to}));
    const dem::Loads loads = app::loads(study.load, 0);
    const app::PushWay way = app::push_way(study.load);
    return {
        {"blocks", blocks},
        {"cracks", cracks},
        {"length", layout.length},
        {"height", layout.height},
        {"load_height", loads.height},
        {"farthest_mm", 1e3 * way.farthest},
        {"direction", way.direction},
        {"stress_MPa", loads.vertical_stress * 1e-6},
        {"notes", app::effect_notes(study, kPush) + app::joint_law_notes(study, study.source)},
        {"study", app::effective_configuration(study)}};
}

Json moving_scene_json(const dem::Snapshot& wall)
{
    Json blocks = Json::array(), faces = Json::array();
    for (const dem::BlockState& b : wall.blocks)
        blocks.push_back(
            {{"outline", point_list(b.outline)}, {"unit", b.unit}, {"course", b.course}});
    for (const dem::FaceState& f : wall.faces) {
        Json at = Json::array();
        for (const dem::ContactState& c : f.contacts)
            at.push_back(corner_at(wall.blocks[f.block_b].outline, c.at));
        faces.push_back({{"crack", f.kind == dem::FaceKind::unit_crack},
                         {"block", f.block_b},
                         {"at", std::move(at)}});
    }
    return {{"blocks", blocks}, {"faces", faces}};
}

std::vector<float> movement_of(const dem::Snapshot& wall)
{
    std::vector<float> numbers;
    const auto add = [&](double x) { numbers.push_back(static_cast<float>(x)); };
    for (const dem::BlockState& b : wall.blocks)
        for (const dem::Point u : b.displacement) {
            add(u.x);
            add(u.z);
        }
    for (const dem::FaceState& f : wall.faces) {
        double damage = f.contacts.empty() ? 0.0 : 1.0, opening = 0.0, slip = 0.0;
        for (const dem::ContactState& c : f.contacts) {
            damage = std::min(damage, c.damage);
            opening = std::max(opening, c.opening);
            slip = std::max(slip, std::abs(c.slip));
        }
        add(damage);
        add(opening);
        add(slip);
    }
    return numbers;
}

Json curve_json(const app::PushedWall& w)
{
    Json displacement = Json::array(), force = Json::array();
    for (const double u : w.displacement) displacement.push_back(app::rounded(u * 1e3, 7));
    for (const double f : w.force) force.push_back(app::rounded(f * 1e-3, 7));
    return {{"displacement_mm", displacement}, {"force_kN", force}};
}

Json limits_json(const app::Study& study, const app::WallReading& reading, double height)
{
    Json list = Json::array();
    const std::vector<app::StateName> names = app::state_names(app::reading_rules(study));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const fragility::LimitDisplacement& limit = reading.limits.at(i);
        list.push_back({{"name", app::state_name(names[i])},
                        {"rule", names[i].rule},
                        {"displacement_mm", app::or_null(limit.displacement, 1e3)},
                        {"drift_percent", app::or_null(drift(limit, height))},
                        {"reading", name(limit.reading)},
                        {"capped", is_capped(limit)},
                        {"reason", limit.reason}});
    }
    return list;
}

Json wall_json(const app::Study& study, int sample, const app::PushedWall& w)
{
    Json j = {{"sample", sample}, {"failed", dem::failed(w.result.outcome)}};
    if (dem::failed(w.result.outcome)) {
        j["reason"] = w.reading.no_reading;
        return j;
    }
    j["mode"] = app::came_down_at_once(w) ? Json(nullptr) : Json(name(w.reading.mode));
    j["peak_kN"] = app::or_null(app::peak_force(w.reading), 1e-3);
    j["curve"] = curve_json(w);
    j["limits"] = limits_json(study, w.reading, w.loads.height);
    return j;
}

Json fit_json(const Json& drifts)
{
    constexpr int kPoints = 80;
    std::vector<fragility::Observation> walls;
    for (const Json& x : drifts.at("observed")) walls.push_back(fragility::observed(x));
    for (const Json& x : drifts.at("censored")) walls.push_back(fragility::right_censored(x));
    for (const Json& x : drifts.at("capped")) {
        walls.push_back(fragility::observed(x));
        walls.back().capped = true;
    }
    Json j = {{"walls", walls.size()}};
    if (walls.empty()) return {{"reason", "no wall was read"}};
    const fragility::KaplanMeier seen = fragility::kaplan_meier(walls);
    Json steps = Json::array();
    for (const fragility::KaplanMeierStep& s : seen.steps)
        steps.push_back({app::rounded(s.at, 7), app::rounded(s.probability, 7)});
    j["steps"] = steps;
    j["end"] = seen.end;
    const fragility::Fit fit = fragility::fit(fragility::Law::lognormal, walls);
    if (fit.outcome != fragility::FitOutcome::converged) {
        j["reason"] = fit.reason;
        return j;
    }
    j["median_percent"] = std::exp(fit.law.location);
    j["dispersion"] = fit.law.dispersion;
    std::vector<double> at;
    for (int i = 1; i <= kPoints; ++i) at.push_back(1.05 * seen.end * i / kPoints);
    Json points = Json::array();
    for (const fragility::FragilityPoint& p : fragility::fragility_curve(fit, at))
        points.push_back({app::rounded(p.drift, 6), app::rounded(p.probability, 6),
                          app::rounded(p.band.lower, 6), app::rounded(p.band.upper, 6)});
    j["points"] = points;
    return j;
}

} // namespace page
