#include "bench/cyclic/single_walls.hpp"

#include "app/output/table/cells.hpp"
#include "dem/block/model.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "scenes/paper_wall.hpp"
#include "scenes/rocking_statics.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bench {
namespace {

struct Loops {
    dem::PushResult result;
    std::vector<fragility::Cycle> cycles;

    /// Energy lost to one part of the ledger in one cycle [J].
    [[nodiscard]] double lost(std::size_t cycle, double dem::Energy::*part) const
    {
        const fragility::Cycle& c = cycles.at(cycle);
        return result.curve[c.end].energy.*part - result.curve[c.begin].energy.*part;
    }
};

Loops loops_of(const dem::Model& m, const dem::WallMaterials& w, std::vector<double> targets,
               const dem::SolverOptions& options = {})
{
    dem::PushPlan plan;
    plan.targets = std::move(targets);
    plan.snapshot_at_peak = false;
    Loops all{dem::push(m, w, plan, options), {}};
    std::vector<double> displacement, force;
    for (const dem::CurvePoint& p : all.result.curve) {
        displacement.push_back(p.displacement);
        force.push_back(p.force);
    }
    all.cycles = fragility::cycles({displacement, force});
    return all;
}

/// To the right and to the left at each amplitude, and back [m].
std::vector<double> there_and_back(const std::vector<double>& amplitudes_mm)
{
    std::vector<double> targets;
    for (const double a : amplitudes_mm) targets.insert(targets.end(), {a * 1e-3, -a * 1e-3});
    targets.push_back(0.0);
    return targets;
}

app::Row slider_row()
{
    constexpr double kHeight = 0.02; // [m]
    scenes::Scene s = scenes::monolith(1.0, kHeight, 0.5e6, 1e10);
    s.wall.toe = dem::Toe::free;
    s.loads.height = kHeight;
    s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
    const dem::Model m = scenes::model_of(s);
    dem::WallMaterials w = scenes::uniform(s, m);
    w.base_joint.tan_phi = 0.1;
    const double t = s.wall.thickness, d = 5e-3;
    const double force = 0.1 * (0.5e6 + s.stone.density * 9.81 * kHeight) * t;
    // Base and beam joint in series, and the turn of the block on its base.
    const double elastic =
        force * (2.0 / (s.joint.ks * t) + 12.0 * kHeight * kHeight / (s.joint.kn * t));
    const Loops l = loops_of(m, w, there_and_back({5, 5, 5}));
    const double whole = 4.0 * force * d;
    const double damping = fragility::equivalent_damping(l.cycles.at(1)).value_or(0.0);
    return {std::string("slides, friction angle 5.7 degrees"),
            app::plain_number(100.0 * l.cycles.at(1).energy / whole, 4),
            app::plain_number(100.0 * (1.0 - elastic / d), 4),
            app::plain_number(100.0 * l.lost(1, &dem::Energy::friction) / whole, 4),
            app::plain_number(100.0 * l.lost(1, &dem::Energy::damping) / whole, 4),
            app::plain_number(100.0 * damping, 3),
            app::plain_number(200.0 / std::numbers::pi * (1.0 - elastic / d), 3)};
}

app::Row rocker_row(double length, dem::Toe toe)
{
    scenes::Scene s = scenes::monolith(length, 1.0, 0.5e6, 8.08e9);
    s.wall.toe = toe;
    const dem::Model m = scenes::model_of(s);
    const double d = 10e-3;
    const Loops l = loops_of(m, scenes::uniform(s, m), there_and_back({10, 10}));
    const double whole = 4.0 * l.cycles.at(1).force_plus * d;
    const double damping = fragility::equivalent_damping(l.cycles.at(1)).value_or(0.0);
    return {"rocks, " + std::to_string(length).substr(0, 3) + " m x 1 m, its toe " +
                (toe == dem::Toe::held ? "held" : "free"),
            app::plain_number(100.0 * l.cycles.at(1).energy / whole, 2),
            app::count(0),
            app::plain_number(100.0 * l.lost(1, &dem::Energy::friction) / whole, 2),
            app::plain_number(100.0 * l.lost(1, &dem::Energy::damping) / whole, 4),
            app::plain_number(100.0 * damping, 2),
            app::count(0)};
}

} // namespace

app::Table block_loops()
{
    app::Table t;
    t.caption = "Blocks on a dry joint under 0.50 MPa, second of two equal cycles of 5 mm "
                "(sliding) and 10 mm (rocking), in percent of 4 F d. Exact: 1 - F/(k d) for "
                "sliding, zero for rocking.";
    t.head = {"block",      "energy [%]",  "exact [%]",        "of it friction [%]",
              "solver [%]", "damping [%]", "exact damping [%]"};
    t.rows = {slider_row(), rocker_row(1.0, dem::Toe::held), rocker_row(1.0, dem::Toe::free),
              rocker_row(0.5, dem::Toe::held), rocker_row(0.5, dem::Toe::free)};
    return t;
}

app::Table rocking_loops()
{
    app::Table t;
    t.caption =
        "The block of 1 m x 1 m with a free toe, second cycle of 10 mm, in percent of 4 F d: "
        "contact points on its faces, accuracy of the push, modes of the block.";
    t.head = {"points",     "accuracy [%]",       "modes",
              "energy [%]", "of it friction [%]", "solver [%]"};
    struct Case {
        int points, modes;
        double accuracy; // [%]
    };
    const dem::Discretisation usual;
    for (const Case& c :
         {Case{usual.contact_points, usual.block_modes, 1}, Case{9, usual.block_modes, 1},
          Case{17, usual.block_modes, 1}, Case{33, usual.block_modes, 1}, Case{33, 3, 1},
          Case{usual.contact_points, usual.block_modes, 0.25}}) {
        scenes::Scene s = scenes::monolith(1.0, 1.0, 0.5e6, 8.08e9);
        s.wall.toe = dem::Toe::free;
        dem::Discretisation d;
        d.contact_points = c.points;
        d.block_modes = c.modes;
        const dem::Model m = scenes::model_of(s, d);
        dem::SolverOptions o;
        o.accuracy = 0.01 * c.accuracy;
        const Loops l = loops_of(m, scenes::uniform(s, m), there_and_back({10, 10}), o);
        const double whole = 4.0 * l.cycles.at(1).force_plus * 10e-3;
        t.rows.push_back(
            {app::count(c.points), app::given(c.accuracy), app::count(c.modes),
             app::plain_number(100.0 * l.cycles.at(1).energy / whole, 2),
             app::plain_number(100.0 * l.lost(1, &dem::Energy::friction) / whole, 2),
             app::plain_number(100.0 * l.lost(1, &dem::Energy::damping) / whole, 4)});
    }
    return t;
}

app::Table rocking_in_balance()
{
    app::Table t;
    t.caption =
        "A rigid block of 1 m x 1 m with a free toe, second of two equal cycles, in percent of "
        "4 F "
        "d: as pushed, and computed in balance at every moment, without masses, damping and "
        "speed.";
    t.head = {"friction angle [degrees]",
              "points",
              "amplitude [mm]",
              "energy [%]",
              "balance [%]",
              "solver [%]",
              "finite displacements [%]"};
    struct Case {
        double angle_deg;
        int points;
        double amplitude_mm;
    };
    for (const Case& c : {Case{25, 17, 10}, Case{31.8, 17, 10}, Case{40, 17, 10},
                          Case{50, 17, 10}, Case{31.8, 5, 10}, Case{31.8, 9, 10},
                          Case{31.8, 33, 10}, Case{31.8, 17, 20}, Case{31.8, 17, 30}}) {
        scenes::Scene s = scenes::monolith(1.0, 1.0, 0.5e6, 8.08e9);
        s.wall.toe = dem::Toe::free;
        s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
        dem::Discretisation d;
        d.contact_points = c.points;
        d.block_modes = d.beam_modes = 3;
        const dem::Model m = scenes::model_of(s, d);
        dem::WallMaterials w = scenes::uniform(s, m);
        w.base_joint.tan_phi = std::tan(c.angle_deg * std::numbers::pi / 180.0);
        const double a = c.amplitude_mm;
        const auto share = [a](const Loops& l, double energy) {
            return 100.0 * energy / (4.0 * l.cycles.at(1).force_plus * a * 1e-3);
        };
        const Loops l = loops_of(m, w, there_and_back({a, a}));
        dem::SolverOptions finite;
        finite.kinematics = dem::Kinematics::finite;
        const Loops turned = loops_of(m, w, there_and_back({a, a}), finite);
        const scenes::RockingLoop exact =
            scenes::rocking_loop(scenes::in_balance(s, w, l.result.at_end), a * 1e-3);
        t.rows.push_back(
            {app::given(c.angle_deg), app::count(c.points), app::count(a),
             app::plain_number(share(l, l.cycles.at(1).energy), 3),
             app::plain_number(100.0 * exact.energy / (4.0 * exact.force * a * 1e-3), 3),
             app::plain_number(share(l, l.lost(1, &dem::Energy::damping)), 4),
             app::plain_number(share(turned, turned.cycles.at(1).energy), 3)});
    }
    return t;
}

app::Table loops_over_speed()
{
    app::Table t;
    t.caption = "The paper's wall with mean values at 0.50 MPa: energy of each cycle [J], and "
                "the share of it that the "
                "solver's damping takes [%], for several accuracies (solver.accuracy; "
                "1 % is the default).";
    t.head = {"accuracy [%]", "steps"};
    const std::vector<double> amplitudes = {1, 3, 6, 10, 15};
    for (const double a : amplitudes) {
        const std::string mm = app::cell_text(app::count(a)) + " mm";
        t.head.emplace_back(mm + " [J]");
        t.head.emplace_back(mm + ", solver [%]");
    }
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model m = scenes::model_of(s);
    for (const double percent : {4.0, 2.0, 1.0, 0.5, 0.25}) {
        dem::SolverOptions o;
        o.accuracy = 0.01 * percent;
        const Loops l = loops_of(m, scenes::uniform(s, m), there_and_back(amplitudes), o);
        app::Row row = {app::given(percent),
                        app::count(static_cast<double>(l.result.cost.steps))};
        for (std::size_t c = 0; c < amplitudes.size(); ++c) {
            row.emplace_back(app::plain_number(l.cycles.at(c).energy, 2));
            row.emplace_back(app::plain_number(
                100.0 * l.lost(c, &dem::Energy::damping) / l.cycles.at(c).energy, 1));
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

app::Table protocol_cost()
{
    app::Table t;
    t.caption = "The paper's wall with mean values: steps of a push of 30 mm, and of cycles of "
                "3, 6, 10, 15, 20 and 30 mm, "
                "which go 11.2 times as far.";
    t.head = {"stress [MPa]", "steps, one way", "steps, cycles", "ratio"};
    for (const double stress : {0.15, 0.50, 0.75, 1.00, 1.25}) {
        const scenes::Scene s = scenes::paper_wall(stress);
        const dem::Model m = scenes::model_of(s);
        const dem::WallMaterials w = scenes::uniform(s, m);
        const auto one = static_cast<double>(loops_of(m, w, {0.03}).result.cost.steps);
        const auto all = static_cast<double>(
            loops_of(m, w, there_and_back({3, 6, 10, 15, 20, 30})).result.cost.steps);
        t.rows.push_back({app::given(stress), app::count(one), app::count(all),
                          app::plain_number(all / one, 2)});
    }
    return t;
}

} // namespace bench
