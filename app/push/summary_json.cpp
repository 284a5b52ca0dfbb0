#include "app/push/summary_json.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/input/study_reading.hpp"
#include "app/program_version.hpp"
#include "app/push/hand_checks.hpp"
#include "app/study/both_ways.hpp"
#include "app/study/mode_rule.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/version.hpp"
#include "dem/solver/energy_parts.hpp"
#include "dem/solver/solver_revision.hpp"

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
                        {"drift_percent",
                         is_defined(limit) ? or_null(100.0 * limit.displacement / rules.height)
                                           : Json(nullptr)},
                        {"reading", name(limit.reading)},
                        {"reason", limit.reason}});
    }
    return list;
}

/// Backbones of a push that turns back, by direction.
Json backbones(const WallReading& reading, const ReadingRules& rules)
{
    Json all = Json::object();
    for (std::size_t i = 0; i < reading.backbones.size(); ++i) {
        const WallReading& r = reading.backbones[i];
        all[std::string(fragility::kSideNames[i])] = {
            {"peak_force_kN", or_null(peak_force(r) * kToKn)},
            {"displacement_at_peak_mm", or_null(peak_displacement(r) * kToMm)},
            {"ultimate_displacement_mm", displacement_mm(r.ultimate)},
            {"ultimate_censored", is_censored(r.ultimate)},
            {"stiffness_kN_per_mm", or_null(r.stiffness, 1e-6)},
            {"no_reading", r.no_reading},
            {"limit_states", limit_states(r, rules)}};
    }
    return all;
}

/// The push the other way.
Json other_way(const PushedWall& other, const ReadingRules& rules)
{
    const WallReading& r = other.reading;
    const bool moved = !dem::failed(other.result.outcome) && !came_down_at_once(other);
    return {{"direction", way_name(-rules.direction)},
            {"peak_force_kN", or_null(peak_force(r) * kToKn)},
            {"displacement_at_peak_mm", or_null(peak_displacement(r) * kToMm)},
            {"ultimate_displacement_mm", displacement_mm(r.ultimate)},
            {"ultimate_censored", is_censored(r.ultimate)},
            {"mode", moved ? Json(name(r.mode)) : Json(nullptr)},
            {"stiffness_kN_per_mm", or_null(r.stiffness, 1e-6)},
            {"no_reading", r.no_reading},
            {"limit_states", limit_states(r, rules)}};
}

/// The smaller of each number of both directions.
Json worse(const Study& study, const PushedWall& w, const ReadingRules& rules)
{
    const WallReading r = worse_way(w);
    Json limits = limit_states(r, rules);
    for (std::size_t i = 0; i < limits.size(); ++i)
        limits[i]["direction"] = worse_way_name(study, w, i);
    return {{"peak_force_kN", or_null(peak_force(r) * kToKn)},
            {"ultimate_displacement_mm", displacement_mm(r.ultimate)},
            {"ultimate_censored", is_censored(r.ultimate)},
            {"limit_states", limits}};
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

Json energy(const dem::Energy& e)
{
    Json all;
    for (const dem::EnergyPart& part : dem::kEnergyParts)
        all[std::string(part.name) + "_J"] = or_null(e.*part.value);
    return all;
}

Json mechanism(const PushedWall& w, const FragilityInput& f)
{
    const dem::ModeThresholds& t = f.mode;
    return {{"rotation_share", or_null(w.mechanism.rotation_share)},
            {"turning_share", or_null(w.mechanism.turning_share)},
            {"sliding_share", or_null(w.mechanism.sliding_share)},
            {"cracked_units", w.mechanism.cracked_units},
            {"spalled_units", w.mechanism.spalled_units},
            {"cracked_contacts", w.mechanism.cracked_contacts},
            {"crushed_contacts", w.mechanism.crushed_contacts},
            {"crushed_through_mm2", or_null(w.mechanism.crushed_area * 1e6)},
            {"brittle_crushing_contacts", w.result.brittle_crushing_contacts},
            {"snap_back_contacts", w.result.snap_back_contacts},
            {"shear_snap_back_contacts", w.result.shear_snap_back_contacts},
            {"crack_contacts", w.result.crack_contacts},
            {"contacts_softened_in_tension", w.result.softened_in_tension},
            {"contacts_softened_in_shear", w.result.softened_in_shear},
            {"slid_whole", w.reading.slid},
            {"mode_rule", mode_rule_text(f)},
            {"mode_thresholds",
             {{"rotation_share", t.rotation_share},
              {"cracked_units", t.cracked_units},
              {"modes", t.modes == dem::ModeRule::paper ? 2 : 3}}}};
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
    const bool whole = !dem::failed(w.result.outcome);
    const WallReading& r = w.reading;
    const FragilityInput& f = study.fragility;
    ReadingRules rules = reading_rules(study);
    rules.height = w.loads.height;
    rules.by_piers = !w.piers.empty();
    Json j;
    j["vertical_stress_MPa"] = or_null(w.vertical_stress * kToMpa);
    j["outcome"] = name(w.result.outcome);
    j["peak_force_kN"] = or_null(peak_force(r) * kToKn);
    if (w.loads.pattern == dem::LoadPattern::body) {
        j["peak_load_factor"] = or_null(peak_force(r) / w.result.weight);
        j["load_factor_rule"] = "horizontal body force over weight; displacements are means "
                                "over the wall by weight";
    }
    j["displacement_at_peak_mm"] = or_null(peak_displacement(r) * kToMm);
    j["peak_is_last_point"] = r.peak ? Json(r.peak->at_end) : Json(nullptr);
    j["ultimate_displacement_mm"] = displacement_mm(r.ultimate);
    j["ultimate_censored"] = is_censored(r.ultimate);
    j["ultimate_rule"] =
        ultimate_text(f) + "; if it never does, censored at the last displacement";
    j["collapse_displacement_mm"] = displacement_mm(r.collapse);
    j["collapse_censored"] = is_censored(r.collapse);
    j["collapse_rule"] =
        "force after the peak first comes down to zero, or the wall comes down; if neither "
        "happens, censored at the last displacement";
    j["mode"] = whole && !came_down_at_once(w) ? Json(name(r.mode)) : Json(nullptr);
    j["stiffness_kN_per_mm"] = or_null(r.stiffness, 1e-6);
    j["stiffness_rule"] = "secant at 30 % of the peak";
    j["no_reading"] = r.no_reading;
    j["load_height_m"] = or_null(w.loads.height);
    j["settlement_mm"] = whole ? or_null(w.result.settlement * kToMm) : Json(nullptr);
    j["limit_states"] = limit_states(r, rules);
    if (!r.backbones.empty()) {
        j["read_on"] = fragility::kSideNames[static_cast<int>(rules.backbone)];
        j["backbones"] = backbones(r, rules);
    }
    add_piers(w, rules, j);
    if (const PushedWall* const other = other_way_of(w)) {
        j["direction"] = way_name(rules.direction);
        j["other_way"] = other_way(*other, rules);
        add_piers(*other, rules, j["other_way"]);
        j["worse"] = worse(study, w, rules);
    }
    j["mechanism"] = mechanism(w, f);
    j["hand_checks"] = checks(hand_checks(study, layout, w));
    j["energy_residual"] = or_null(energy_residual(w));
    j["solver_error_percent"] = or_null(100.0 * solver_error(w));
    j["energy"] = energy(w.result.energy);
    j["settled_before_push"] = w.result.settled;
    j["step_fraction"] = w.result.step_fraction;
    j["step_reductions"] = w.result.step_reductions;
    j["slow_starts"] = w.result.slow_starts;
    j["slowdowns"] = w.result.slowdowns;
    j["steps"] = w.result.cost.steps;
    j["contact_updates"] = w.result.cost.contact_updates;
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
