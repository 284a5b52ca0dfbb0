#include "bench/accuracy/convergence_sweeps.hpp"

#include "app/text/number_text.hpp"

namespace bench {

Case reference(double stress)
{
    Case c;
    c.scene = scenes::paper_wall(stress);
    c.discretisation.contact_points = 6;
    c.discretisation.face_rule = dem::FaceRule::lobatto;
    c.discretisation.zones_per_interval = 2;
    c.discretisation.block_modes = 0;
    c.solver.accuracy = 0.001;
    return c;
}

namespace {

template <class T> Row with(T dem::Discretisation::*field, T value, std::string label)
{
    return {std::move(label), [=](Case& c) { c.discretisation.*field = value; }};
}

template <class T> Row with(T dem::SolverOptions::*field, T value, std::string label)
{
    return {std::move(label), [=](Case& c) { c.solver.*field = value; }};
}

Sweep constant_drive_sweep()
{
    Sweep s{"Drive at constant speed",
            "The error is made where units crack: the drive moves on while the wall releases "
            "energy.",
            "steps per mm",
            {}};
    for (const double steps : {200.0, 500.0, 1000.0, 1500.0, 3000.0, 6000.0})
        s.rows.push_back({app::number(steps, 5), [=](Case& c) {
                              c.solver.steps_per_mm = steps;
                              c.solver.unbalance_limit = 0.0;
                          }});
    return s;
}

Sweep accuracy_sweep()
{
    Sweep s{"Drive that holds an accuracy", "", "accuracy [%]", {}};
    for (const double percent : {10.0, 3.0, 1.0, 0.3, 0.1, 0.03})
        s.rows.push_back(
            with(&dem::SolverOptions::accuracy, 0.01 * percent, app::number(percent, 3)));
    return s;
}

Sweep unbalance_sweep()
{
    Sweep s{"Unbalance at which the drive waits",
            "As a share of the error that is borne, at an accuracy of 1 %.",
            "limit [-]",
            {}};
    for (const double limit : {1.0, 0.7, 0.5, 0.3, 0.1})
        s.rows.push_back({app::number(limit, 3), [=](Case& c) {
                              c.solver.accuracy = 0.01;
                              c.solver.unbalance_limit = limit;
                          }});
    return s;
}

Sweep points_sweep(dem::FaceRule rule)
{
    const bool even = rule == dem::FaceRule::even;
    Sweep s;
    s.title = even ? "Contact points per face of a half unit, evenly spaced"
                   : "Contact points per face of a half unit, Gauss-Lobatto";
    s.text = "All zones, two between neighbouring points.";
    s.head = "points";
    for (const int n :
         even ? std::vector<int>{2, 3, 4, 5, 7, 9, 13} : std::vector<int>{3, 4, 5, 6, 8, 10})
        s.rows.push_back({std::to_string(n), [=](Case& c) {
                              c.discretisation.face_rule = rule;
                              c.discretisation.contact_points = n;
                          }});
    return s;
}

Sweep zones_sweep()
{
    Sweep s{"Zones between neighbouring contact points", "", "zones", {}};
    for (const int z : {1, 2, 3, 4})
        s.rows.push_back(with(&dem::Discretisation::zones_per_interval, z, std::to_string(z)));
    return s;
}

Sweep modes_sweep()
{
    Sweep s{"Modes per block",
            "3 rigid, 6 with constant strain, all: the zones in full.",
            "modes",
            {}};
    for (const int m : {3, 6, 9, 12, 18, 24})
        s.rows.push_back(with(&dem::Discretisation::block_modes, m, std::to_string(m)));
    s.rows.push_back(with(&dem::Discretisation::block_modes, 0, "all (40)"));
    for (const int m : {3, 40})
        s.rows.push_back(
            with(&dem::Discretisation::beam_modes, m, "all; beam " + std::to_string(m)));
    return s;
}

Sweep damping_sweep()
{
    Sweep s{"Damping",
            "Local damping (Eq. 1) drags steady motion: its error falls with the speed only.",
            "damping",
            {}};
    for (const double gamma : {0.3, 0.5, 0.8})
        s.rows.push_back(with(&dem::SolverOptions::damping_factor, gamma,
                              "combined " + app::number(gamma, 2)));
    for (const double steps : {1500.0, 6000.0, 12000.0})
        s.rows.push_back(
            {"local 0.8, constant speed, " + app::number(steps, 5) + " steps per mm",
             [=](Case& c) {
                 c.solver.damping = dem::Damping::local;
                 c.solver.unbalance_limit = 0.0;
                 c.solver.steps_per_mm = steps;
             }});
    return s;
}

Sweep rest_sweep()
{
    Sweep s{"Time step, preload and curve points", "", "setting", {}};
    for (const double f : {0.95, 0.7, 0.5})
        s.rows.push_back(with(&dem::SolverOptions::step_fraction, f,
                              "step " + app::number(f, 2) + " of the bound"));
    s.rows.push_back(with(&dem::SolverOptions::preload_unbalance, 1e-6, "preload to 1e-6"));
    for (const double every : {2e-5, 5e-5, 1e-4})
        s.rows.push_back({"curve point every " + app::number(every * 1e3, 2) + " mm",
                          [=](Case& c) { c.record_every = every; }});
    return s;
}

Sweep default_sweep()
{
    Sweep s{"Default settings against the reference", "", "settings", {}};
    s.rows.push_back({"default", [](Case& c) {
                          c.discretisation = {};
                          c.solver = {};
                      }});
    s.rows.push_back({"reference", [](Case&) {}});
    return s;
}

/// Choices of the model, not of the numerics: at the default settings.
Sweep model_sweep()
{
    Sweep s{"Choices of the model",
            "At default settings. The first row is the default.",
            "choice",
            {}};
    const auto add = [&s](std::string label, std::function<void(Case&)> change) {
        s.rows.push_back({std::move(label), [change = std::move(change)](Case& c) {
                              c.discretisation = {};
                              c.solver = {};
                              change(c);
                          }});
    };
    add("fixed base, load at 1.10 m, tied beam, coupled law", [](Case&) {});
    add("load at 1.05 m", [](Case& c) { c.scene.loads.height = 1.05; });
    add("load at 1.15 m (beam as heavy, 0.15 m)", [](Case& c) {
        c.scene.beam.material.density *= c.scene.beam.height / 0.15;
        c.scene.beam.height = 0.15, c.scene.loads.height = 1.15;
    });
    add("first course on a joint", [](Case& c) { c.scene.wall.base = dem::Base::joint; });
    add("toe free", [](Case& c) { c.scene.wall.toe = dem::Toe::free; });
    add("beam on a dry joint",
        [](Case& c) { c.scene.beam.interface = dem::BeamInterface::joint; });
    add("beam of 0.5 kN", [](Case& c) { c.scene.beam.material.density = 2400.0; });
    add("beam ten times stiffer", [](Case& c) { c.scene.beam.material.young_modulus *= 10.0; });
    add("stone 2700 kg/m3", [](Case& c) { c.scene.stone.density = 2700.0; });
    add("uncoupled law", [](Case& c) { c.solver.law = dem::ContactLaw::uncoupled; });
    add("tension does not lower the shear strength",
        [](Case& c) { c.scene.crack.tension_reduces_shear = false; });
    add("units do not crack", [](Case& c) { c.scene.crack.ft = c.scene.crack.cohesion = 1e9; });
    add("fracture energy 55 N/m", [](Case& c) { c.scene.crack.fracture_energy = 55.0; });
    add("unit stiffness ratio 5",
        [](Case& c) { c.scene.crack.kn *= 0.5, c.scene.crack.ks *= 0.5; });
    add("unit stiffness ratio 20",
        [](Case& c) { c.scene.crack.kn *= 2.0, c.scene.crack.ks *= 2.0; });
    return s;
}

} // namespace

std::vector<Sweep> convergence_sweeps()
{
    return {default_sweep(),
            constant_drive_sweep(),
            accuracy_sweep(),
            unbalance_sweep(),
            points_sweep(dem::FaceRule::even),
            points_sweep(dem::FaceRule::lobatto),
            zones_sweep(),
            modes_sweep(),
            damping_sweep(),
            rest_sweep(),
            model_sweep()};
}

} // namespace bench
