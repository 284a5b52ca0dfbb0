#include "bench/counting_number.hpp"
#include "bench/speed/work_count.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/step.cpp" // NOLINT: for one more kind of number
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <vector>

/// Only the step of small displacements under a load on the beam is counted here.
template <>
void dem::finite_step(const StepTables&, const SolverOptions&,
                      const StepInput<counting::Counted>&, WallState<counting::Counted>&)
{
}

template <>
void dem::move_by_body_forces(const StepTables&, const SolverOptions&,
                              const StepInput<counting::Counted>&,
                              WallState<counting::Counted>&)
{
}

namespace {

using counting::Counted;

/// One unit of two rigid blocks on a dry joint, two points per face, under a rigid beam: small
/// enough to count by hand.
scenes::Scene one_unit()
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = s.wall.unit_length;
    s.wall.courses = 1;
    s.wall.base = dem::Base::joint;
    s.wall.toe = dem::Toe::free;
    s.loads.height = s.wall.course_height + s.beam.height;
    return s;
}

dem::Discretisation coarse()
{
    dem::Discretisation d;
    d.contact_points = 2;
    d.block_modes = d.beam_modes = 3;
    return d;
}

std::vector<Counted> counted(const std::vector<double>& values)
{
    return {values.begin(), values.end()};
}

dem::WallState<Counted> counted(const dem::WallState<double>& s)
{
    dem::WallState<Counted> c;
    c.q = counted(s.q);
    c.v = counted(s.v);
    c.last_force = counted(s.last_force);
    c.laws.inv_mass = counted(s.laws.inv_mass);
    c.laws.load = counted(s.laws.load);
    c.laws.elasticity = counted(s.laws.elasticity);
    c.block_force = counted(s.block_force);
    c.du = counted(s.du);
    c.stress = counted(s.stress);
    c.u_n = counted(s.u_n);
    for (const auto& m : s.cracks)
        c.cracks.push_back({m.u_max, m.bond, m.unloading, m.integrity});
    for (const auto& l : s.laws.dry) c.laws.dry.push_back({l.kn, l.ks, l.inv_ks, l.tan_phi});
    for (const auto& l : s.laws.tied) c.laws.tied.push_back({l.kn, l.ks, l.inv_ks, l.tan_phi});
    for (const auto& l : s.laws.cracks)
        c.laws.cracks.push_back({l.kn, l.ks, l.inv_ks, l.ft, l.u_el, l.inv_softening,
                                 l.cohesion_res, l.cohesion_drop, l.tan_phi_res, l.tan_phi_drop,
                                 l.tension_weight});
    return c;
}

/// Operations of a step, counted while it is done.
long long operations_of_a_step(const scenes::Scene& scene, const dem::Discretisation& d)
{
    const dem::Model model = scenes::model_of(scene, d);
    const dem::StepTables tables = dem::step_tables(model);
    const dem::WallMaterials wall = scenes::uniform(scene, model);
    dem::WallState<double> at_rest = dem::unloaded<double>(model, tables, {&wall, 1}, {});
    REQUIRE(dem::solve_preload(tables, at_rest));
    dem::WallState<Counted> state = counted(at_rest);
    counting::operations = 0;
    dem::step(tables, {}, {Counted(1.0), Counted(1e-7)}, state);
    return counting::operations;
}

} // namespace

TEST_CASE("work count: one unit counted by hand", "[bench][work_count]")
{
    const dem::Model model = scenes::model_of(one_unit(), coarse());
    const bench::StepWork w = bench::work_of(dem::step_tables(model));
    CHECK(w.blocks == 3);
    CHECK(w.dry == 4);    // two base faces of two points
    CHECK(w.tied == 4);   // two beam faces
    CHECK(w.cracks == 2); // one crack
    CHECK(w.contacts() == 10);
    CHECK(w.ports ==
          6 + 6 + 4); // base, crack, beam points of each half; beam points of the beam
    CHECK(w.modes == 3 + 3 + 2); // the beam's sway is prescribed
    // forces and displacements x normal and tangential x ports x modes
    CHECK(w.multiply_adds == 2 * 2 * (6 * 3 + 6 * 3 + 4 * 2));
    CHECK(w.matrix_bytes == 8 * w.multiply_adds); // no two of these blocks are alike
    CHECK(w.dry_laws == 2 + 2);
    CHECK(w.crack_laws == 1);
}

TEST_CASE("work count: a step does as many operations as its tables say", "[bench][work_count]")
{
    scenes::Scene scene = one_unit();
    dem::Discretisation d = coarse();
    SECTION("one unit, rigid") {}
    SECTION("the paper's wall, rigid")
    {
        scene = scenes::paper_wall(0.75);
        d = dem::discretisation_of(dem::Fidelity::rigid);
    }
    SECTION("the paper's wall, default")
    {
        scene = scenes::paper_wall(0.75);
        d = {};
    }
    const bench::StepWork w = bench::work_of(dem::step_tables(scenes::model_of(scene, d)));
    CHECK(operations_of_a_step(scene, d) == w.multiply_adds + w.operations);
}

TEST_CASE("work count: a pack moves as many bytes as its lanes would apart, tables but once",
          "[bench][work_count]")
{
    const bench::StepWork w =
        bench::work_of(dem::step_tables(scenes::model_of(scenes::paper_wall(0.75))));
    const bench::Traffic one = bench::traffic_of(w, 8), eight = bench::traffic_of(w, 64);
    CHECK(eight.written == 8.0 * one.written);
    const double tables = static_cast<double>(w.matrix_bytes + 8 * w.contacts()) +
                          4.0 * static_cast<double>(w.ports);
    CHECK(eight.read - tables == 8.0 * (one.read - tables));
    CHECK(eight.state - tables == 8.0 * (one.state - tables));
}

TEST_CASE("work count: the state counted is the state there is", "[bench][work_count]")
{
    const dem::Model model = scenes::model_of(one_unit(), coarse());
    const dem::StepTables tables = dem::step_tables(model);
    const auto s = dem::empty_lanes<double>(model, tables);
    const std::size_t laws = 4 * (tables.dry.size() + tables.tied.size()) + 11;
    const std::size_t numbers = s.q.size() + s.v.size() + s.last_force.size() +
                                s.laws.inv_mass.size() + s.laws.load.size() +
                                s.laws.elasticity.size() + s.du.size() + s.stress.size() +
                                s.u_n.size() + 4 * s.cracks.size() + laws;
    const bench::StepWork w = bench::work_of(tables);
    const double more = static_cast<double>(bench::traffic_of(w, 16).state) -
                        static_cast<double>(bench::traffic_of(w, 8).state);
    CHECK(more == 8.0 * static_cast<double>(numbers));
}
