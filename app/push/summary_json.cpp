#include "app/push/summary_json.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/energy_json.hpp"
#include "app/program_version.hpp"
#include "app/push/hand_checks.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/version.hpp"
#include "dem/solver/solver_revision.hpp"
#include "fragility/curve/drift.hpp"

namespace app {

namespace {

constexpr double kToMm = 1e3, kToKn = 1e-3, kToMpa = 1e-6;

Json displacement_mm(const fragility::LimitDisplacement& d)
{
    return is_defined(d) ? or_null(d.displacement * kToMm) : Json(nullptr);
}

Json limit_states(const WallReading& reading, const ReadingRules& rules)
{
    Json list = Json::array();
    if (!reading.no_reading.empty()) return list;
    const std::vector<StateName> names = state_names(rules);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const fragility::LimitDisplacement& limit = reading.limits.at(i);
        list.push_back({{"set", names[i].set},
                        {"name", names[i].name},
                        {"rule", names[i].rule},
                        {"displacement_mm", displacement_mm(limit)},
                        {"drift_percent", or_null(fragility::percent_drift(
                                              displacement_of(limit), rules.height))},
                        {"reading", name(limit.reading)},
                        {"reason", limit.reason}});
    }
    return list;
}

void add_number(const WallNumber& n, const WallSource& wall, Json& j)
{
    const double x = value(n, wall);
    const bool count = n.decimals == 0 && n.unit.name == "-";
    j[summary_key(n)] = count ? Json(static_cast<std::int64_t>(x)) : or_null(x, n.unit.scale);
}

void add_numbers(const WallSource& wall, Json& j, const auto&... numbers)
{
    (add_number(numbers, wall, j), ...);
}

/// Numbers of one direction, one backbone, or the worse of both directions.
Json readings(const WallSource& wall)
{
    Json j = Json::object();
    add_numbers(wall, j, wall_number("peak_force"), wall_number("peak_displacement"),
                wall_number("ultimate_displacement"), wall_number("ultimate_drift"));
    j["ultimate_censored"] = is_censored(wall.reading.ultimate);
    add_number(wall_number("secant_stiffness"), wall, j);
    return j;
}

Json with_limits(Json j, const WallReading& reading, const ReadingRules& rules)
{
    j["no_reading"] = reading.no_reading;
    j["limit_states"] = limit_states(reading, rules);
    return j;
}

/// Backbones of a push that turns back, by direction.
Json backbones(const PushedWall& w, const ReadingRules& rules)
{
    Json all = Json::object();
    for (std::size_t i = 0; i < w.reading.backbones.size(); ++i) {
        const WallReading& r = w.reading.backbones[i];
        all[std::string(fragility::kSideNames[i])] =
            with_limits(readings(source_of(w, r)), r, rules);
    }
    return all;
}

Json mode_json(const PushedWall& w)
{
    const bool moved = !dem::failed(w.result.outcome) && !came_down_at_once(w);
    return moved ? Json(name(w.reading.mode)) : Json(nullptr);
}

/// The push the other way.
Json other_way(const PushedWall& other, const ReadingRules& rules)
{
    Json j = {{"direction", way_name(-rules.direction)}};
    j.update(readings(source_of(other)));
    j["mode"] = mode_json(other);
    return with_limits(j, other.reading, rules);
}

/// The smaller of each number of both directions.
Json worse(const PushedWall& w, const ReadingRules& rules)
{
    const WallReading r = worse_way(w);
    Json j = with_limits(readings(source_of(w, r)), r, rules);
    for (std::size_t i = 0; i < j["limit_states"].size(); ++i)
        j["limit_states"][i]["direction"] = worse_way_name(rules.direction, w, i);
    return j;
}

/// "ntc"; of a code with several drift limits "mine CP".
std::string cap_name(const PierReading& pier, const PierCap& cap)
{
    const bool alone = std::ranges::count(pier.caps, cap.code, &PierCap::code) == 1;
    return alone ? cap.code : cap.code + " " + cap.state;
}

Json piers(const PushedWall& w, const ReadingRules& rules)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < w.piers.size(); ++i) {
        const PierReading& p = w.piers[i];
        ReadingRules own = rules;
        own.height = p.pier.at.z1 - p.pier.at.z0;
        own.slenderness = p.facts.slenderness;
        own.by_piers = false;
        Json caps = Json::object();
        for (const PierCap& cap : p.caps)
            caps[cap_name(p, cap)] = {{"drift_percent", or_null(100.0 * cap.drift)},
                                      {"wall_displacement_mm", displacement_mm(cap.wall)},
                                      {"censored", is_censored(cap.wall)}};
        all.push_back({{"pier", i + 1},
                       {"storey", p.pier.storey},
                       {"from_m", or_null(p.pier.at.x0)},
                       {"to_m", or_null(p.pier.at.x1)},
                       {"bottom_m", or_null(p.pier.at.z0)},
                       {"top_m", or_null(p.pier.at.z1)},
                       {"axial_before_kN", or_null(p.facts.normal_before * kToKn)},
                       {"axial_at_peak_kN", or_null(p.facts.normal_at_peak * kToKn)},
                       {"shear_at_peak_kN", or_null(p.facts.shear_at_peak * kToKn)},
                       {"largest_shear_kN", or_null(p.facts.most_shear * kToKn)},
                       {"drift_at_end_percent", or_null(100.0 * p.drift)},
                       {"mode", p.moved ? Json(name(p.mode)) : Json(nullptr)},
                       {"mode_so_far", p.mode_so_far},
                       {"carries", p.carries},
                       {"h0_over_d", or_null(p.facts.slenderness)},
                       {"drift_limits", caps},
                       {"limit_states", limit_states(p.own, own)}});
    }
    return all;
}

/// Nothing where piers are not told apart.
void add_piers(const PushedWall& w, const ReadingRules& rules, Json& j)
{
    if (w.piers.empty()) return;
    j["piers"] = piers(w, rules);
    j["pier_balance"] = {{"shear_percent", or_null(100.0 * w.pier_balance.shear)},
                         {"axial_percent", or_null(100.0 * w.pier_balance.normal)}};
}

Json mechanism(const PushedWall& w, const FragilityInput& f)
{
    const dem::ModeThresholds& t = f.mode;
    Json j = Json::object();
    add_numbers(source_of(w), j, wall_number("rotation_share"), wall_number("turning_share"),
                wall_number("sliding_share"), wall_number("cracked_units"),
                wall_number("spalled_units"), wall_number("cracked_contacts"),
                wall_number("crushed_contacts"), wall_number("crushed_area"),
                wall_number("brittle_crushing_contacts"), wall_number("snap_back_contacts"),
                wall_number("shear_snap_back_contacts"), wall_number("crack_contacts"),
                wall_number("contacts_softened_in_tension"),
                wall_number("contacts_softened_in_shear"));
    j["slid_whole"] = w.reading.slid;
    j["mode_rule"] = mode_rule_text(f);
    j["mode_thresholds"] = {{"rotation_share", t.rotation_share},
                            {"cracked_units", t.cracked_units},
                            {"modes", t.modes == dem::ModeRule::paper ? 2 : 3}};
    return j;
}

Json checks(const HandChecks& h)
{
    return {
        {"vertical_load_kN", or_null(h.vertical_load * kToKn)},
        {"wall_weight_kN", or_null(h.wall_weight * kToKn)},
        {"wall_weight_rule", "of what can turn: without the stones that are held on the floor"},
        {"rigid_rocking_limit_kN", or_null(h.rocking_limit, kToKn)},
        {"sliding_limit_kN", or_null(h.sliding_limit, kToKn)},
        {"toe_stress_MPa", or_null(h.toe_stress, kToMpa)},
        {"remarks", h.remarks}};
}

} // namespace

std::string summary_json(const Study& study, const dem::Layout& layout, const PushedWall& w)
{
    const WallSource source = source_of(w);
    const WallReading& r = w.reading;
    const FragilityInput& f = study.fragility;
    ReadingRules rules = reading_rules(study);
    rules.height = w.loads.height;
    rules.by_piers = !w.piers.empty();
    Json j;
    j["vertical_stress_MPa"] = or_null(w.vertical_stress * kToMpa);
    j["outcome"] = name(w.result.outcome);
    j.update(readings(source));
    if (w.loads.pattern == dem::LoadPattern::body) {
        j["peak_load_factor"] = or_null(peak_force(r) / w.result.weight);
        j["load_factor_rule"] = "horizontal body force over weight; displacements are means "
                                "over the wall by weight";
    }
    j["peak_is_last_point"] = r.peak ? Json(r.peak->at_end) : Json(nullptr);
    j["ultimate_rule"] =
        ultimate_text(f) + "; if it never does, censored at the last displacement";
    add_number(wall_number("collapse_displacement"), source, j);
    j["collapse_censored"] = is_censored(r.collapse);
    j["collapse_rule"] =
        "force after the peak first comes down to zero, or the wall comes down; if neither "
        "happens, censored at the last displacement";
    j["mode"] = mode_json(w);
    j["stiffness_rule"] = "secant at 30 % of the peak";
    j["no_reading"] = r.no_reading;
    j["load_height_m"] = or_null(w.loads.height);
    add_number(wall_number("settlement"), source, j);
    j["limit_states"] = limit_states(r, rules);
    if (!r.backbones.empty()) {
        j["read_on"] = fragility::kSideNames[static_cast<int>(rules.backbone)];
        j["backbones"] = backbones(w, rules);
    }
    add_piers(w, rules, j);
    if (const PushedWall* const other = other_way_of(w)) {
        j["direction"] = way_name(rules.direction);
        j["other_way"] = other_way(*other, rules);
        add_piers(*other, rules, j["other_way"]);
        j["worse"] = worse(w, rules);
    }
    j["mechanism"] = mechanism(w, f);
    j["hand_checks"] = checks(hand_checks(study, layout, w));
    j["energy_residual"] = or_null(value(wall_number("energy_residual"), source));
    add_number(wall_number("solver_error"), source, j);
    add_number(wall_number("ultimate_error"), source, j);
    add_number(wall_number("points_error"), source, j);
    j["energy"] = energy_json(w.result.energy);
    j["settled_before_push"] = w.result.settled;
    add_numbers(source, j, wall_number("step_fraction"), wall_number("step_reductions"),
                wall_number("slow_starts"), wall_number("slowdowns"), wall_number("steps"),
                wall_number("contact_updates"));
    j["solver_seconds"] = w.result.cost.seconds;
    j["contact_updates_per_second"] =
        or_null(static_cast<double>(w.result.cost.contact_updates) / w.result.cost.seconds);
    j["version"] = kVersion;
    j["commit"] = commit().empty() ? Json(nullptr) : Json(commit());
    j["solver_revision"] = dem::kSolverRevision;
    j["study"] = effective_configuration(study);
    return text_of(j, 2) + "\n";
}

} // namespace app
