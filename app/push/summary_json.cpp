#include "app/push/summary_json.hpp"

#include "app/study/mode_rule.hpp"
#include "app/version.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kToMm = 1e3, kToKn = 1e-3, kToMpa = 1e-6;

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json displacement_mm(const fragility::LimitDisplacement& d)
{
    return d.reading == fragility::Reading::not_defined ? Json(nullptr)
                                                        : Json(d.displacement * kToMm);
}

const char* name(fragility::Reading r)
{
    switch (r) {
    case fragility::Reading::observed:
        return "observed";
    case fragility::Reading::censored:
        return "censored";
    case fragility::Reading::not_defined:
        return "not defined";
    }
    return "";
}

const char* name(dem::Outcome o)
{
    switch (o) {
    case dem::Outcome::reached_target:
        return "reached target";
    case dem::Outcome::decided:
        return "decided";
    case dem::Outcome::lost_equilibrium:
        return "lost equilibrium";
    case dem::Outcome::not_finite:
        return "not finite";
    case dem::Outcome::energy_astray:
        return "energy astray";
    case dem::Outcome::out_of_steps:
        return "out of steps";
    case dem::Outcome::no_wall:
        return "no wall";
    }
    return "";
}

Json limit_states(const PushedWall& w)
{
    Json list = Json::array();
    for (const fragility::LimitState& s : w.limit_states)
        list.push_back(
            {{"name", s.name},
             {"rule", s.rule},
             {"displacement_mm", displacement_mm(s.limit)},
             {"drift_percent", s.limit.reading == fragility::Reading::not_defined
                                   ? Json(nullptr)
                                   : Json(100.0 * s.limit.displacement / w.loads.height)},
             {"reading", name(s.limit.reading)},
             {"reason", s.limit.reason}});
    return list;
}

Json energy(const dem::Energy& e)
{
    return {
        {"work_J", number_or_null(e.work)},         {"elastic_J", number_or_null(e.elastic)},
        {"friction_J", number_or_null(e.friction)}, {"fracture_J", number_or_null(e.fracture)},
        {"damping_J", number_or_null(e.damping)},   {"kinetic_J", number_or_null(e.kinetic)}};
}

Json mechanism(const PushedWall& w)
{
    const dem::ModeThresholds t;
    return {{"rotation_share", number_or_null(w.mechanism.rotation_share)},
            {"sliding_share", number_or_null(w.mechanism.sliding_share)},
            {"cracked_units", w.mechanism.cracked_units},
            {"cracked_contacts", w.mechanism.cracked_contacts},
            {"snap_back_contacts", w.result.snap_back_contacts},
            {"mode_rule", mode_rule_text(t)},
            {"mode_thresholds",
             {{"rotation_share", t.rotation_share}, {"cracked_units", t.cracked_units}}}};
}

/// Largest share of the work missing from the ledger at any point of the curve; NaN if any of
/// them is.
double worst_residual(const PushedWall& w)
{
    double worst = std::abs(w.result.energy.residual());
    for (const dem::CurvePoint& p : w.result.curve) {
        const double r = std::abs(p.energy.residual());
        if (!(r <= worst)) worst = r;
        if (std::isnan(worst)) break;
    }
    return worst;
}

} // namespace

const char* name(dem::FailureMode mode)
{
    return mode == dem::FailureMode::rocking ? "rocking" : "mixed";
}

std::string summary_json(const Study& study, const PushedWall& w)
{
    const bool whole = !dem::failed(w.result.outcome);
    Json j;
    j["vertical_stress_MPa"] = w.vertical_stress * kToMpa;
    j["outcome"] = name(w.result.outcome);
    j["peak_force_kN"] = w.peak ? Json(w.peak->force * kToKn) : Json(nullptr);
    j["displacement_at_peak_mm"] = w.peak ? Json(w.peak->displacement * kToMm) : Json(nullptr);
    j["peak_is_last_point"] = w.peak ? Json(w.peak->at_end) : Json(nullptr);
    j["ultimate_displacement_mm"] = displacement_mm(w.ultimate);
    j["ultimate_censored"] = w.ultimate.reading == fragility::Reading::censored;
    j["ultimate_rule"] = "force first comes down to 80 % of the peak; if it never does, "
                         "censored at the last displacement";
    j["mode"] = whole ? Json(name(w.mode)) : Json(nullptr);
    j["stiffness_kN_per_mm"] = w.stiffness ? Json(*w.stiffness * 1e-6) : Json(nullptr);
    j["stiffness_rule"] = "secant at 30 % of the peak";
    j["no_reading"] = w.no_reading;
    j["load_height_m"] = w.loads.height;
    j["settlement_mm"] = whole ? number_or_null(w.result.settlement * kToMm) : Json(nullptr);
    j["limit_states"] = limit_states(w);
    j["mechanism"] = mechanism(w);
    j["energy_residual"] = number_or_null(worst_residual(w));
    j["energy"] = energy(w.result.energy);
    j["settled_before_push"] = w.result.settled;
    j["step_fraction"] = w.result.step_fraction;
    j["step_reductions"] = w.result.step_reductions;
    j["steps"] = w.result.cost.steps;
    j["contact_updates"] = w.result.cost.contact_updates;
    j["solver_seconds"] = w.result.cost.seconds;
    j["contact_updates_per_second"] = number_or_null(
        static_cast<double>(w.result.cost.contact_updates) / w.result.cost.seconds);
    j["version"] = kVersion;
    j["study"] = effective_configuration(study);
    return j.dump(2) + "\n";
}

} // namespace app
