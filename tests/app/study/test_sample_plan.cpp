#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/sampling/wall_sites.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "dem/scene/layout.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

using app::layout_of;
using app::SamplePlan;
using app::Study;
using app::WallDraw;
using study_scenes::study;

namespace {

SamplePlan plan_of(const Study& s, std::vector<std::uint32_t> sizes = {})
{
    if (sizes.empty()) sizes = {static_cast<std::uint32_t>(s.uq.samples)};
    return sample_plan(s, s.load, s.source, layout_of(s, s.source), sizes);
}

double mean_of(const SamplePlan& plan, std::size_t input, int level)
{
    double sum = 0.0;
    const auto n = static_cast<int>(plan.design.front().rows());
    for (int i = 0; i < n; ++i) sum += app::draw(plan, level, i).values[input].front();
    return sum / n;
}

} // namespace

TEST_CASE("sample plan: means of 50 samples are those of Table 5 within 0.2 %, each variable "
          "and level",
          "[app][sample_plan]")
{
    const Study s = study("samples = 50\ndesign = lhs_centred"); // as configs/paper.ini
    const SamplePlan plan = plan_of(s);
    const double deg = std::numbers::pi / 180.0;
    const std::vector<double> table5 = {31.8 * deg, 1.0, 3.7e6, 35.0 * deg, 1.0};
    REQUIRE(plan.inputs.size() == table5.size());
    for (int level = 0; level < 2; ++level)
        for (std::size_t i = 0; i < table5.size(); ++i) {
            INFO(plan.inputs[i].key);
            CHECK(mean_of(plan, i, level) == Approx(table5[i]).epsilon(2e-3));
        }
}

TEST_CASE("sample plan: levels have samples of their own, unless shared", "[app][sample_plan]")
{
    const SamplePlan own = plan_of(study("samples = 8"));
    CHECK(app::draw(own, 0, 3).values != app::draw(own, 1, 3).values);
    const SamplePlan shared = plan_of(study("samples = 8\nshared = yes"));
    CHECK(app::draw(shared, 0, 3).values == app::draw(shared, 1, 3).values);
}

TEST_CASE("sample plan: a level has the same samples alone and among others",
          "[app][sample_plan]")
{
    std::string one = study_scenes::kSmall;
    one.replace(one.find("0.50, 1.00 MPa"), 14, "1.00 MPa");
    one.replace(one.find("768, 1057 MPa"), 13, "1057 MPa");
    const SamplePlan both = plan_of(study("samples = 8")),
                     alone = plan_of(study("samples = 8", one));
    CHECK(app::draw(both, 1, 5).values == app::draw(alone, 0, 5).values);
}

TEST_CASE("sample plan: a field of correlation 0 is the independent case, of correlation 1 the "
          "non-spatial one, to the bit",
          "[app][sample_plan]")
{
    const std::string field = "samples = 6\nspatial = correlated\nkernel = all\n";
    const SamplePlan zero = plan_of(study(field + "group_correlation = 0"));
    const SamplePlan independent = plan_of(study("samples = 6\nspatial = independent"));
    const SamplePlan one = plan_of(study(field + "group_correlation = 1"));
    const SamplePlan none = plan_of(study("samples = 6"));
    for (int i = 0; i < 6; ++i) {
        CHECK(app::draw(zero, 0, i).values == app::draw(independent, 0, i).values);
        const WallDraw a = app::draw(one, 0, i), b = app::draw(none, 0, i);
        for (std::size_t v = 0; v < b.values.size(); ++v)
            for (const double x : a.values[v]) CHECK(x == b.values[v].front());
    }
}

TEST_CASE(
    "sample plan: stratified draws fill one stratum of the marginal by each joint of a wall",
    "[app][sample_plan]")
{
    const SamplePlan plan = plan_of(study("samples = 3\nspatial = stratified"));
    const WallDraw d = app::draw(plan, 1, 2);
    for (std::size_t v = 0; v < d.values.size(); ++v) {
        const std::size_t n = d.values[v].size();
        REQUIRE(n > 1);
        std::set<long> strata;
        for (const double x : d.values[v])
            strata.insert(std::lround(
                std::floor(uq::cdf(plan.inputs[v].marginal, x) * static_cast<double>(n))));
        CHECK(strata.size() == n);
    }
    CHECK(app::draw(plan, 1, 1).values != d.values);
}

TEST_CASE("sample plan: near joints are alike in a field, far ones less", "[app][sample_plan]")
{
    const Study s = study("samples = 300\nspatial = correlated\nkernel = exponential\n"
                          "correlation_length = 0.2 m\ndesign = monte_carlo");
    const SamplePlan plan = plan_of(s);
    const auto sites = app::joint_sites(layout_of(s, s.source));
    const auto correlation = [&](std::size_t a,
                                 std::size_t b) { // of the stiffness factor: normal
        double ab = 0.0;
        for (int i = 0; i < 300; ++i) {
            const std::vector<double> x = app::draw(plan, 0, i).values[1];
            ab += (x[a] - 1.0) * (x[b] - 1.0) / (0.25 * 0.25) / 300.0;
        }
        return ab;
    };
    for (const std::size_t b : {std::size_t{1}, sites.size() - 1}) {
        const double d = std::hypot(sites[0].x - sites[b].x, sites[0].z - sites[b].z);
        const double rho = std::exp(-d / 0.2);
        CHECK(std::abs(correlation(0, b) - rho) < 4.0 * std::sqrt((1.0 + rho * rho) / 300.0));
    }
}

TEST_CASE("sample plan: what a field lacks is said", "[app][sample_plan]")
{
    const auto complaint = [](const std::string& uq) {
        try {
            plan_of(study("samples = 6\nspatial = correlated\n" + uq));
        } catch (const app::ConfigError& e) {
            return std::string(e.what());
        }
        return std::string("none");
    };
    CHECK(complaint("kernel = matern").find("uq.correlation_length: missing") !=
          std::string::npos);
    CHECK(complaint("correlation_length = 1, 2 m").find("takes one") != std::string::npos);
    CHECK(complaint("kernel = all\ncorrelation_length = 1 m").find("no meaning") !=
          std::string::npos);
}

TEST_CASE("sample plan: values that follow from random ones follow their draw",
          "[app][sample_plan]")
{
    for (const char* spatial : {"none", "independent"}) {
        const Study s = study(std::string("samples = 4\nspatial = ") + spatial);
        const dem::Layout layout = layout_of(s, s.source);
        const WallDraw d = app::draw(plan_of(s), 0, 2);
        const dem::WallMaterials w =
            app::wall_materials(s, s.random, app::stress_level(s.load, 0), layout, d);
        for (std::size_t k = 0; k < w.cracks.size(); ++k) {
            CHECK(w.cracks[k].ft == d.values[2][k % d.values[2].size()]);
            CHECK(w.cracks[k].cohesion == w.cracks[k].ft);
            CHECK(w.cracks[k].tan_phi_res == w.cracks[k].tan_phi);
        }
        for (std::size_t k = 0; k < w.joints.size(); ++k) {
            const std::size_t at = k % d.values[0].size();
            CHECK(w.joints[k].tan_phi == std::tan(d.values[0][at]));
            CHECK(
                w.joints[k].kn ==
                Approx(d.values[1][at] * app::joint_material(s.parameters, s.wall.course_height,
                                                             app::stress_level(s.load, 0))
                                             .kn)
                    .epsilon(1e-14));
        }
    }
}

TEST_CASE("sample plan: the columns of a study say where each joint and crack is",
          "[app][sample_plan]")
{
    const std::vector<app::Column> columns =
        app::input_columns(plan_of(study("samples = 2\nspatial = independent")));
    const auto meaning = [&](const std::string& name) {
        return std::ranges::find(columns, name, &app::Column::name)->meaning;
    };
    CHECK(meaning("joint.friction_angle.1") ==
          "of this joint ID, middle at x = 0.2 m, z = 0.05 m");
    CHECK(meaning("unit.tensile_strength.1") ==
          "of this crack ID, middle at x = 0.1 m, z = 0.05 m");
}

TEST_CASE("sample plan: sites of joints and cracks are where Fig. 13 has them",
          "[app][wall_sites]")
{
    dem::WallGeometry wall;
    wall.length = 1.0;
    wall.courses = 10;
    wall.course_height = 0.1;
    wall.unit_length = 0.2;
    wall.thickness = 0.2;
    const dem::Layout layout = dem::lay_out(wall, 0.1);
    const auto joints = app::joint_sites(layout), cracks = app::crack_sites(layout);
    REQUIRE(joints.size() == 135);
    REQUIRE(cracks.size() == 45);
    CHECK(joints[0].x == Approx(0.2)); // first head joint of the bottom course
    CHECK(joints[0].z == Approx(0.05));
    CHECK(joints[4].x == Approx(0.05)); // first piece of the bed joint above it
    CHECK(joints[4].z == Approx(0.1));
    CHECK(cracks[0].x == Approx(0.1));
    CHECK(cracks[0].course == 1);
    CHECK(cracks[0].unit != cracks[1].unit);

    const auto places = app::joint_places(layout);
    CHECK(app::kind_name(places[0].kind) == "head joint");
    CHECK(app::kind_name(places[4].kind) == "bed joint");
    CHECK(places[4].length == Approx(0.1)); // half a unit
    CHECK(app::kind_name(app::crack_places(layout)[0].kind) == "crack");
}

TEST_CASE(
    "sample plan: correlated inputs have their correlation, and a Latin hypercube stays one",
    "[app][sample_plan]")
{
    const std::string pair = "pearson = joint.friction_angle joint.stiffness_factor 0.6\n";
    const SamplePlan plan = plan_of(study("samples = 400\n" + pair));
    double xy = 0.0, xx = 0.0, yy = 0.0;
    std::set<long> strata;
    const double mean = uq::mean(plan.inputs[0].marginal);
    for (int i = 0; i < 400; ++i) {
        const WallDraw d = app::draw(plan, 0, i);
        const double x = d.values[0].front() - mean, y = d.values[1].front() - 1.0;
        xy += x * y, xx += x * x, yy += y * y;
        strata.insert(std::lround(
            std::floor(uq::cdf(plan.inputs[0].marginal, d.values[0].front()) * 400.0)));
    }
    CHECK(xy / std::sqrt(xx * yy) == Approx(0.6).margin(0.02));
    CHECK(strata.size() == 400);
    const SamplePlan grown = plan_of(study("samples = 60\n" + pair), {40, 60});
    const SamplePlan small = plan_of(study("samples = 40\n" + pair));
    CHECK(app::draw(grown, 0, 39).values == app::draw(small, 0, 39).values);
}

TEST_CASE("sample plan: correlations that cannot be are refused", "[app][sample_plan]")
{
    const auto complaint = [](const std::string& uq) {
        try {
            plan_of(study("samples = 20\n" + uq));
        } catch (const app::ConfigError& e) {
            return std::string(e.what());
        }
        return std::string("none");
    };
    const std::string a = "joint.friction_angle", b = "joint.stiffness_factor",
                      c = "unit.friction_angle";
    CHECK(complaint("pearson = " + a + " " + b + " 1.2").find("uq.pearson") !=
          std::string::npos);
    CHECK(complaint("pearson = " + a + " joint.stifness_factor 0.2").find("did you mean") !=
          std::string::npos);
    CHECK(complaint("pearson = " + a + " " + b).find("two inputs and their correlation") !=
          std::string::npos);
    CHECK(complaint("pearson = " + a + " " + b + " 0.9, " + b + " " + c + " 0.9, " + a + " " +
                    c + " -0.9")
              .find("nearest") != std::string::npos);
    CHECK(complaint("spatial = independent\npearson = " + a + " " + c + " 0.5")
              .find("same joints") != std::string::npos);
}

TEST_CASE("sample plan: the configuration that a study keeps makes the same walls again",
          "[app][sample_plan]")
{
    const Study s = study("samples = 4\nspatial = independent");
    const Study again =
        app::prepare(
            app::read_study(app::parse_study_text("kept.ini", effective_configuration(s))))
            .study;
    CHECK(identity_text(again) == identity_text(s));
    const dem::Layout layout = layout_of(s, s.source);
    for (int i = 0; i < 4; ++i) {
        const dem::WallMaterials a = wall_materials(s, s.random, stress_level(s.load, 1),
                                                    layout, app::draw(plan_of(s), 1, i)),
                                 b = wall_materials(again, again.random,
                                                    stress_level(again.load, 1), layout,
                                                    app::draw(plan_of(again), 1, i));
        for (std::size_t k = 0; k < a.cracks.size(); ++k) {
            CHECK(a.cracks[k].kn == b.cracks[k].kn);
            CHECK(a.cracks[k].cohesion == b.cracks[k].cohesion);
            CHECK(a.cracks[k].tan_phi_res == b.cracks[k].tan_phi_res);
        }
        for (std::size_t k = 0; k < a.joints.size(); ++k)
            CHECK(a.joints[k].ks == b.joints[k].ks);
    }
}

TEST_CASE("sample plan: every joint closes by its own draw, cracks and supports by that of the "
          "wall",
          "[app][sample_plan]")
{
    std::string text = study_scenes::kSmall;
    const std::string modulus = "wall_modulus = 768, 1057 MPa\n";
    text.replace(text.find(modulus), modulus.size(),
                 "closure = hyperbolic\nmaximum_closure = 0.15 mm\n"
                 "initial_stiffness = lognormal(mean 4.87 GPa/m, cov 0.3)\n");
    for (const char* spatial : {"none", "independent"}) {
        const Study s = study(std::string("samples = 4\nspatial = ") + spatial, text);
        REQUIRE(s.random[2].key == "joint.initial_stiffness");
        const WallDraw d = app::draw(plan_of(s), 1, 2);
        const dem::WallMaterials w = app::wall_materials(
            s, s.random, app::stress_level(s.load, 1), layout_of(s, s.source), d);
        const std::vector<double>& factor = d.values[1];
        const std::vector<double>& first = d.values[2];
        const double of_wall = first.size() == 1 ? first.front() : s.random[2].mean;
        for (std::size_t k = 0; k < w.joints.size(); ++k) {
            const double f = factor[k % factor.size()], k0 = first[k % first.size()];
            CHECK(w.joints[k].closing.initial_stiffness == f * k0);
            CHECK(w.joints[k].closing.stiffest == Approx(f * 100.0 * of_wall).epsilon(1e-14));
            CHECK(w.joints[k].kn == Approx(f * (k0 + 1e6 / 0.15e-3)).epsilon(1e-14));
            CHECK(w.joints[k].ks == Approx(w.joints[k].kn / 2.4).epsilon(1e-14));
        }
        CHECK(w.base_joint.kn == Approx(of_wall + 1e6 / 0.15e-3).epsilon(1e-14));
        const std::vector<double>& crack = d.values.back(); // unit.stiffness_factor
        for (std::size_t k = 0; k < w.cracks.size(); ++k)
            CHECK(w.cracks[k].kn ==
                  Approx(crack[k % crack.size()] * 10.0 * w.base_joint.kn).epsilon(1e-14));
    }
}

TEST_CASE("sample plan: a joint whose residual friction follows its own does not wear",
          "[app][sample_plan]")
{
    std::string text = study_scenes::kSmall;
    text.insert(text.find("[joint]\n") + 8, "wear_length = 5 mm\n");
    const Study s = study("samples = 4\nspatial = independent", text);
    const dem::WallMaterials w =
        app::wall_materials(s, s.random, app::stress_level(s.load, 0), layout_of(s, s.source),
                            app::draw(plan_of(s), 0, 1));
    for (const dem::JointMaterial& joint : w.joints)
        CHECK(joint.wear.tan_phi_res == Approx(joint.tan_phi).epsilon(1e-14));
}

TEST_CASE("sample plan: uq.together reads lists row by row; what has no rows is refused",
          "[app][sample_plan]")
{
    std::string text = study_scenes::kSmall;
    const auto put = [&](std::string_view old, std::string_view now) {
        text.replace(text.find(old), old.size(), now);
    };
    put("friction_angle = normal(mean 31.8 deg, cov 0.20)\nstiffness_factor = normal(mean 1, "
        "cov "
        "0.25)",
        "friction_angle = empirical(33, 29, 31 deg)\nstiffness_factor = empirical(0.8, 1.3, "
        "1)");
    const std::string together = "together = joint.friction_angle, joint.stiffness_factor\n";
    const Study s = study("samples = 6\n" + together, text);
    const SamplePlan plan = plan_of(s);
    for (int k = 0; k < 6; ++k) {
        const WallDraw wall = app::draw(plan, 0, k);
        const double angle = std::round(wall.values[0].front() * 180.0 / std::numbers::pi);
        CHECK(wall.values[1].front() == (angle == 33.0 ? 0.8 : angle == 29.0 ? 1.3 : 1.0));
    }
    // another order of the rows is another study
    std::string other = text;
    other.replace(other.find("33, 29"), 6, "29, 33");
    CHECK(identity_text(study("samples = 6\n" + together, other)) != identity_text(s));
    const auto refused = [&](const std::string& uq, const std::string& message) {
        CHECK_THROWS_WITH(plan_of(study("samples = 6\n" + uq, text)), Catch::Contains(message));
    };
    refused("together = joint.friction_angle\n", "uq.together: names one input");
    refused("together = joint.friction_angle, joint.friction\n", "is not a random input");
    refused("together = joint.friction_angle, joint.friction_angle\n", "is named twice");
    refused("together = joint.friction_angle, unit.tensile_strength\n",
            "unit.tensile_strength is not a list");
    refused(together + "spatial = independent\n", "varies from joint to joint");
    refused(together + "pearson = joint.friction_angle joint.stiffness_factor 0.1\n",
            "stands in uq.pearson too");
    put("empirical(0.8, 1.3, 1)", "empirical(0.8, 1.3)");
    refused(together, "joint.stiffness_factor has 2 values, and the first input has 3");
}
