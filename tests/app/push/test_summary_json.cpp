#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/push/level_table.hpp"
#include "app/push/summary_json.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace {

std::string summary_of(const app::Study& study, const app::PushedWall& w)
{
    return app::summary_json(study, app::layout_of(study, study.source), w);
}

using app::PushedWall;
using Json = nlohmann::ordered_json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

dem::Energy balanced()
{
    dem::Energy e;
    e.work = 100.0;
    e.elastic = 20.0;
    e.friction = 70.0;
    e.fracture = 5.0;
    e.damping = 4.0;
    e.kinetic = 1.0;
    return e;
}

fragility::LimitDisplacement reading(double displacement, fragility::Reading r,
                                     std::string_view reason = "")
{
    return {displacement, r, reason};
}

/// A wall pushed to 30 mm with all readings.
PushedWall good_wall()
{
    PushedWall w;
    w.vertical_stress = 0.5e6;
    w.loads.height = 1.1;
    w.result.energy = balanced();
    w.result.curve = {{0.0, 0.0, 0.0, 0.0, balanced()}, {0.03, 40e3, 40e3, 0.0, balanced()}};
    w.result.settled = true;
    w.result.settlement = 0.7e-3;
    w.result.snap_back_contacts = 3;
    w.result.shear_snap_back_contacts = 4;
    w.result.crack_contacts = 225;
    w.result.softened_in_tension = 5;
    w.result.softened_in_shear = 6;
    w.result.cost = {1000, 500000, 0.25};
    w.mechanism = {0.9, 0.1, 2, 7};
    w.reading.mode = dem::FailureMode::mixed;
    for (int i = 0; i <= 60; ++i) {
        w.displacement.push_back(0.0005 * i);
        w.force.push_back(40e3 * i / 60);
    }
    w.reading.peak = fragility::Peak{50e3, 0.012, false};
    w.reading.stiffness = 25e6;
    w.reading.ultimate = reading(0.018, fragility::Reading::observed);
    w.reading.collapse = reading(0.030, fragility::Reading::censored);
    w.reading.limits = {
        reading(0.018, fragility::Reading::observed),
        reading(0.0, fragility::Reading::not_defined, "no elastic branch"),
        reading(0.0, fragility::Reading::not_defined, "no elastic branch"),
        reading(0.0225, fragility::Reading::censored, "SLC is"),
        reading(0.030, fragility::Reading::censored, "the curve ends")}; // paper, ntc
    return w;
}

/// As push_level leaves a wall whose numbers broke.
PushedWall broken_wall()
{
    PushedWall w;
    w.vertical_stress = 0.5e6;
    w.loads.height = 1.1;
    w.result.outcome = dem::Outcome::not_finite;
    w.result.energy = {kNan, kNan, kNan, kNan, kNan, kNan, kNan};
    w.result.curve = {{0.0, 0.0, 0.0, 0.0, balanced()},
                      {0.01, kNan, kNan, kNan, w.result.energy}};
    w.result.settlement = kNan;
    w.result.cost = {1000, 500000, 0.25};
    w.mechanism = {kNan, kNan, 0, 0};
    w.reading.no_reading = "the numbers of this run are not finite";
    return w;
}

Json summary(const PushedWall& w)
{
    return Json::parse(summary_of(study_texts::read_good(), w));
}

/// Whether any number anywhere in a JSON value is not finite.
bool has_broken_number(const Json& j)
{
    if (j.is_number_float()) return !std::isfinite(j.get<double>());
    if (!j.is_structured()) return false;
    for (const Json& item : j)
        if (has_broken_number(item)) return true;
    return false;
}

std::vector<std::string> keys_of(const Json& j)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : j.items()) keys.push_back(key);
    return keys;
}

std::set<std::string> null_keys(const Json& j)
{
    std::set<std::string> keys;
    for (const auto& [key, value] : j.items())
        if (value.is_null()) keys.insert(key);
    return keys;
}

} // namespace

TEST_CASE("summary: a number that was given has the digits that were given",
          "[app][summary_json]")
{
    PushedWall w = good_wall();
    w.vertical_stress = 0.4 * 1e6; // times 1e-6 it is 0.39999999999999997
    CHECK(summary(w).at("vertical_stress_MPa").dump() == "0.4");
}

TEST_CASE("summary: numbers are in the units of their keys", "[app][summary_json]")
{
    app::PushedWall wall = good_wall();
    wall.reading.ultimate_range = {{0.0171, fragility::Reading::observed, {}},
                                   {0.0180, fragility::Reading::observed, {}}};
    const Json j = summary(wall);
    const auto value = [&j](const char* key) { return j.at(key).get<double>(); };
    CHECK(value("vertical_stress_MPa") == Approx(0.5).epsilon(1e-14));
    CHECK(value("peak_force_kN") == Approx(50.0).epsilon(1e-14));
    CHECK(value("peak_displacement_mm") == Approx(12.0).epsilon(1e-14));
    CHECK(value("ultimate_displacement_mm") == Approx(18.0).epsilon(1e-14));
    CHECK(value("ultimate_error_percent") == Approx(5.0));
    CHECK(value("secant_stiffness_kN_per_mm") == Approx(25.0).epsilon(1e-14));
    CHECK(value("settlement_mm") == Approx(0.7).epsilon(1e-14));
    CHECK(value("load_height_m") == Approx(1.1).epsilon(1e-14));
    CHECK(value("solver_seconds") == 0.25);
    CHECK(value("contact_updates_per_second") == Approx(2e6).epsilon(1e-14));
    CHECK(j.at("steps") == 1000);
    CHECK(j.at("contact_updates") == 500000);
    CHECK(j.at("energy").at("work_J") == 100.0);
    CHECK(j.at("energy").at("friction_J") == 70.0);
    CHECK(null_keys(j) == std::set<std::string>{"points_error_percent"}); // no snapshot
}

TEST_CASE("summary: a wall with readings says what it did", "[app][summary_json]")
{
    PushedWall w = good_wall();
    Json j = summary(w);
    CHECK(j.at("outcome") == "reached target");
    CHECK(j.at("mode") == "mixed");
    CHECK(j.at("no_reading") == "");
    CHECK(j.at("ultimate_censored") == false);
    CHECK(j.at("peak_is_last_point") == false);
    const Json& m = j.at("mechanism");
    CHECK(m.at("rotation_share") == 0.9);
    CHECK(m.at("sliding_share") == 0.1);
    CHECK(m.at("cracked_units") == 2);
    CHECK(m.at("cracked_contacts") == 7);
    CHECK(m.at("snap_back_contacts") == 3);
    CHECK(m.at("shear_snap_back_contacts") == 4);
    CHECK(m.at("crack_contacts") == 225);
    CHECK(m.at("contacts_softened_in_tension") == 5);
    CHECK(m.at("contacts_softened_in_shear") == 6);

    w.reading.mode = dem::FailureMode::rocking;
    w.reading.ultimate =
        reading(0.03, fragility::Reading::censored, "the curve ends above 80 %");
    w.reading.peak->at_end = true;
    w.result.outcome = dem::Outcome::lost_equilibrium;
    j = summary(w);
    CHECK(j.at("mode") == "rocking");
    CHECK(j.at("ultimate_censored") == true);
    CHECK(j.at("ultimate_displacement_mm").get<double>() == Approx(30.0).epsilon(1e-14));
    CHECK(j.at("peak_is_last_point") == true);
    CHECK(j.at("outcome") == "lost equilibrium");
}

TEST_CASE(
    "summary: limit states carry reading, reason and rule; what is not defined has no number",
    "[app][summary_json]")
{
    const Json list = summary(good_wall()).at("limit_states");
    REQUIRE(list.size() == 5);
    CHECK(list[0].at("set") == "paper");
    CHECK(list[0].at("name") == "ultimate");
    CHECK(list[0].at("rule") == "first drop to 80 % of the peak");
    CHECK(list[0].at("reading") == "observed");
    CHECK(list[0].at("displacement_mm").get<double>() == Approx(18.0).epsilon(1e-14));
    CHECK(list[0].at("drift_percent").get<double>() ==
          Approx(100 * 0.018 / 1.1).epsilon(1e-14));
    CHECK(list[3].at("name") == "SLV");
    CHECK(list[3].at("reading") == "censored");
    CHECK(list[3].at("reason") == "SLC is");
    CHECK(list[3].at("displacement_mm").get<double>() == Approx(22.5).epsilon(1e-14));
    CHECK(list[2].at("reading") == "not defined");
    CHECK(list[2].at("reason") == "no elastic branch");
    CHECK(list[2].at("displacement_mm").is_null());
    CHECK(list[2].at("drift_percent").is_null());
}

TEST_CASE("summary: the energy residual is the worst of the run, without its sign",
          "[app][summary_json]")
{
    PushedWall w = good_wall();
    CHECK(summary(w).at("energy_residual") == 0.0);
    w.result.residual = 0.2; // of the run; what is missing at its end is no other number
    w.result.energy.work = 101.0;
    CHECK(summary(w).at("energy_residual").get<double>() == 0.2);
}

TEST_CASE("summary: the solver's error is there in percent, and above the accuracy a remark",
          "[app][summary_json]")
{
    PushedWall w = good_wall();
    w.result.solver_error = 0.023;
    const app::Study study = study_texts::read_good({"solver.accuracy=2 %"});
    const auto remarks = [&] {
        return Json::parse(summary_of(study, w)).at("hand_checks").at("remarks").dump();
    };
    w.result.slowdowns = 2;
    CHECK(summary(w).at("solver_error_percent").get<double>() == Approx(2.3));
    CHECK(summary(w).at("slowdowns") == 2);
    CHECK(
        remarks().find("the peak force may be wrong by 2.3 % because of the speed of the push, "
                       "more than the 2 % asked for (solver.accuracy)") != std::string::npos);
    w.result.solver_error = 0.02;
    CHECK(remarks().find("solver.accuracy") == std::string::npos);
    using fragility::Reading;
    w.reading.ultimate_range = {{0.0171, Reading::observed, {}},
                                {0.0196, Reading::observed, {}}};
    CHECK(remarks().find("ultimate displacement may be") == std::string::npos); // 9 %
    w.reading.ultimate_range.latest = {0.028, Reading::censored, {}};
    CHECK(
        remarks().find("the ultimate displacement may be anything between 17.10 and more than "
                       "28.00 mm, because the force stays so close to 80 % of the peak") !=
        std::string::npos);
}

TEST_CASE("summary: a wall whose numbers broke has null for every number of its run",
          "[app][summary_json]")
{
    const std::string text = summary_of(study_texts::read_good(), broken_wall());
    const Json j = Json::parse(text);
    CHECK_FALSE(has_broken_number(j));
    CHECK(j.at("outcome") == "not finite");
    CHECK(j.at("no_reading") == "the numbers of this run are not finite");
    CHECK(null_keys(j) ==
          std::set<std::string>{
              "peak_force_kN", "peak_displacement_mm", "collapse_displacement_mm",
              "peak_is_last_point", "ultimate_displacement_mm", "ultimate_drift_percent",
              "mode", "secant_stiffness_kN_per_mm", "settlement_mm", "energy_residual",
              "solver_error_percent", "ultimate_error_percent", "points_error_percent"});
    CHECK(null_keys(j.at("energy")).size() == 7);
    CHECK(null_keys(j.at("mechanism")) ==
          std::set<std::string>{"rotation_share", "sliding_share"});
    CHECK(j.at("limit_states").empty());
    CHECK(j.at("vertical_stress_MPa") == 0.5); // what it was asked
    CHECK(j.at("steps") == 1000);              // and what it took
}

TEST_CASE("summary: numbers that left their range are null, one by one", "[app][summary_json]")
{
    const double broken = GENERATE(as<double>{}, kNan, kInfinity, -kInfinity);
    PushedWall w = good_wall();
    w.result.settlement = broken;
    w.mechanism.sliding_share = broken;
    w.result.energy.kinetic = broken;
    w.reading.peak->force = broken;
    w.reading.stiffness = broken;
    const Json j = summary(w);
    CHECK_FALSE(has_broken_number(j));
    CHECK(j.at("settlement_mm").is_null());
    CHECK(j.at("mechanism").at("sliding_share").is_null());
    CHECK(j.at("energy").at("kinetic_J").is_null());
    CHECK(j.at("peak_force_kN").is_null());
    CHECK(j.at("secant_stiffness_kN_per_mm").is_null());
    CHECK(j.at("peak_displacement_mm").get<double>() == Approx(12.0).epsilon(1e-14));
}

TEST_CASE("summary: hand checks are those of a rigid wall, and a force beyond them is remarked",
          "[app][summary_json]")
{
    const app::Study study = study_texts::read_good(
        {"wall.length=1 m", "wall.courses=10", "wall.course_height=0.1 m",
         "wall.thickness=0.2 m", "wall.base=joint", "stone.density=2000 kg/m3",
         "beam.height=0.1 m", "beam.density=2500 kg/m3", "beam.rotation=free",
         "joint.friction_angle=5 deg", "load.height=1.1 m"});
    PushedWall w = good_wall();
    w.reading.peak = fragility::Peak{40e3, 0.012, false};
    w.loads.height = 1.1;
    w.loads.gravity = 10.0;
    dem::FaceState base;
    base.kind = dem::FaceKind::base_joint;
    base.block_a = -1;
    base.contacts.resize(2);
    base.contacts[0].sigma = -0.4e6;
    base.contacts[1].sigma = -2.5e6;
    w.result.at_end.faces = {base};
    const Json j = Json::parse(summary_of(study, w)).at("hand_checks");
    // 0.5 MPa on 0.2 m2 and a beam of 0.5 kN; ten courses of 0.4 kN
    CHECK(j.at("vertical_load_kN").get<double>() == Approx(100.5));
    CHECK(j.at("wall_weight_kN").get<double>() == Approx(4.0));
    CHECK(j.at("rigid_rocking_limit_kN").get<double>() == Approx(104.5 * 0.5 / 1.1));
    CHECK(j.at("sliding_limit_kN").get<double>() ==
          Approx(std::tan(5.0 * std::acos(-1.0) / 180.0) * 100.9));
    CHECK(j.at("toe_stress_MPa").get<double>() == Approx(2.5));
    REQUIRE(j.at("remarks").size() ==
            1); // 40 kN is below rocking and far beyond sliding at 5 deg
    CHECK(j.at("remarks")[0].get<std::string>().find("limit of sliding") != std::string::npos);
}

TEST_CASE("summary: hand checks of body forces are those of a rigid wall",
          "[app][summary_json]")
{
    const app::Study study = study_texts::read_good(
        {"wall.length=1 m", "wall.courses=10", "wall.course_height=0.1 m",
         "wall.thickness=0.2 m", "stone.density=2000 kg/m3", "beam.height=0.1 m",
         "beam.density=2500 kg/m3", "beam.rotation=free", "joint.friction_angle=5 deg"});
    PushedWall w = good_wall();
    w.vertical_stress = 0.0;
    w.loads.pattern = dem::LoadPattern::body;
    w.loads.gravity = 10.0;
    w.result.weight = 4.5e3;
    const Json j = Json::parse(summary_of(study, w)).at("hand_checks");
    // Nine courses of 0.4 kN that can turn, and a beam of 0.5 kN: f = 4.1 * 0.5 / (3.6 * 0.45 +
    // 0.5 * 0.95)
    const double f = 2.05 / (3.6 * 0.45 + 0.5 * 0.95);
    CHECK(j.at("rigid_rocking_limit_kN").get<double>() == Approx(4.5 * f));
    CHECK(j.at("sliding_limit_kN").get<double>() ==
          Approx(std::tan(5.0 * std::acos(-1.0) / 180.0) * 4.5));
}

TEST_CASE("summary: a peak that comes between two recorded points is remarked",
          "[app][summary_json]")
{
    const auto remarked = [](const PushedWall& w) {
        const Json remarks = summary(w).at("hand_checks").at("remarks");
        return remarks.dump().find(
                   "the true peak may be higher; write a smaller output.record_every") !=
               std::string::npos;
    };
    PushedWall w = good_wall();
    CHECK_FALSE(remarked(w));
    w.force = {0.0, 31e3, 50e3, 20e3}; // 38 % in one step
    w.displacement = {0.0, 1e-4, 2e-4, 3e-4};
    CHECK(remarked(w));
    for (double& f : w.force) f = -f; // pushed to the left
    CHECK(remarked(w));
    w.force = {0.0, 48e3, 50e3, 20e3}; // 4 %
    CHECK(remarked(w));
    w.force = {0.0, 49e3, 50e3, 20e3}; // 2 %: a fall after the peak is no fault
    CHECK_FALSE(remarked(w));
}

TEST_CASE("summary: a joint that slid off its neighbour with small displacements is remarked",
          "[app][summary_json]")
{
    const auto remarked = [](double slip, double sigma, const std::string& kinematics) {
        PushedWall w = good_wall();
        dem::FaceState joint;
        joint.kind = dem::FaceKind::head_joint;
        joint.contacts.resize(2);
        joint.contacts[1].at.x = 0.1;
        joint.contacts[1].slip = slip;
        joint.contacts[1].sigma = sigma;
        w.result.at_end.faces = {joint};
        const app::Study study = study_texts::read_good({"solver.kinematics=" + kinematics});
        const Json j = Json::parse(summary_of(study, w)).at("hand_checks");
        return j.at("remarks").dump().find("a joint that is 100 mm long has slid by 26 mm") !=
               std::string::npos;
    };
    CHECK(remarked(0.026, -1e6, "small"));
    CHECK(remarked(-0.026, -1e6, "small"));
    CHECK_FALSE(remarked(0.024, -1e6, "small")); // a quarter of its length is no fault
    CHECK_FALSE(remarked(0.026, 0.0, "small"));  // an open joint carries nothing
    CHECK_FALSE(remarked(0.026, -1e6, "finite"));
}

TEST_CASE("summary: a run that took no time has no speed", "[app][summary_json]")
{
    PushedWall w = good_wall();
    w.result.cost = {0, 0, 0.0};
    CHECK(summary(w).at("contact_updates_per_second").is_null());
    w.result.cost = {1, 1, 0.0};
    CHECK(summary(w).at("contact_updates_per_second").is_null());
}

TEST_CASE("summary: a wall that is not read has a mode", "[app][summary_json]")
{
    PushedWall w = good_wall();
    w.reading.peak.reset();
    w.reading.stiffness.reset();
    w.reading.ultimate = {};
    w.reading.collapse = {};
    w.reading.no_reading = "the push never goes to this side";
    const Json j = summary(w);
    CHECK(null_keys(j) ==
          std::set<std::string>{"peak_force_kN", "peak_displacement_mm", "peak_is_last_point",
                                "ultimate_displacement_mm", "ultimate_drift_percent",
                                "collapse_displacement_mm", "secant_stiffness_kN_per_mm",
                                "ultimate_error_percent", "points_error_percent"});
    CHECK(j.at("ultimate_censored") == false);
    CHECK(j.at("mode") == "mixed");
}

TEST_CASE(
    "summary: a wall that came down before it was pushed has no mode, one that did not come "
    "to rest has a remark",
    "[app][summary_json]")
{
    PushedWall w = good_wall();
    const auto remarked = [&] {
        const Json j = summary(w);
        for (const Json& remark : j.at("hand_checks").at("remarks"))
            if (remark.get<std::string>().find("had not come to rest") != std::string::npos)
                return true;
        return false;
    };
    CHECK_FALSE(remarked());
    w.result.settled = false;
    CHECK(remarked());
    CHECK(summary(w).at("mode") == "mixed");
    w.result.outcome = dem::Outcome::lost_equilibrium;
    w.displacement = w.force = {0.0};
    CHECK_FALSE(remarked());
    CHECK(summary(w).at("mode").is_null());
}

TEST_CASE("summary: the table of levels has the same numbers", "[app][summary_json]")
{
    PushedWall w = good_wall();
    w.result.solver_error = 0.004;
    w.result.residual = 3e-5;
    const Json j = summary(w);
    const app::Study study = study_texts::read_good();
    const app::PlainTable t = app::plain(app::level_table(study.load, study.fragility, {w}));
    int same = 0;
    for (const app::WallNumber& n : app::kWallNumbers) {
        const auto at = std::ranges::find(t.head, app::head_text(n));
        const Json& in = j.contains(app::summary_key(n)) ? j : j.at("mechanism");
        const auto number = in.find(app::summary_key(n));
        if (at == t.head.end() || number == in.end() || !number->is_number()) continue;
        INFO(n.name);
        const auto& cell = t.rows.front().at(static_cast<std::size_t>(at - t.head.begin()));
        CHECK(std::get<double>(cell) == number->get<double>());
        ++same;
    }
    CHECK(same == 7);
}

TEST_CASE("summary: what others read by name comes in a fixed order", "[app][summary_json]")
{
    const std::vector<std::string> expected = {"vertical_stress_MPa",
                                               "outcome",
                                               "peak_force_kN",
                                               "peak_displacement_mm",
                                               "ultimate_displacement_mm",
                                               "ultimate_drift_percent",
                                               "ultimate_censored",
                                               "secant_stiffness_kN_per_mm",
                                               "peak_is_last_point",
                                               "ultimate_rule",
                                               "collapse_displacement_mm",
                                               "collapse_censored",
                                               "collapse_rule",
                                               "mode",
                                               "stiffness_rule",
                                               "no_reading",
                                               "load_height_m",
                                               "settlement_mm",
                                               "limit_states",
                                               "mechanism",
                                               "hand_checks",
                                               "energy_residual",
                                               "solver_error_percent",
                                               "ultimate_error_percent",
                                               "points_error_percent",
                                               "energy",
                                               "settled_before_push",
                                               "step_fraction",
                                               "step_reductions",
                                               "slow_starts",
                                               "slowdowns",
                                               "steps",
                                               "contact_updates",
                                               "solver_seconds",
                                               "contact_updates_per_second",
                                               "version",
                                               "commit",
                                               "solver_revision",
                                               "study"};
    CHECK(keys_of(summary(good_wall())) == expected);
    CHECK(keys_of(summary(broken_wall())) == expected); // broken numbers keep their place
}

TEST_CASE("summary: the study inside it is the one that ran", "[app][summary_json]")
{
    const app::Study study = study_texts::read_good({"wall.courses=7", "load.height=0.75m"});
    const Json j = Json::parse(summary_of(study, good_wall()));
    const std::string text = j.at("study").get<std::string>();
    CHECK(text == app::effective_configuration(study));
    CHECK(study_texts::read(text).wall.courses == 7);
}
