#include "bench/work_precision.hpp"

namespace bench {

namespace {

Setting setting(std::string family, dem::Fidelity fidelity, double steps_per_mm)
{
    Setting s;
    s.family = std::move(family);
    s.fidelity = fidelity;
    s.discretisation = dem::discretisation_of(fidelity);
    s.solver.steps_per_mm = steps_per_mm;
    return s;
}

void add_ladder(std::vector<Setting>& all)
{
    const std::pair<const char*, dem::Fidelity> rungs[] = {
        {"rigid", dem::Fidelity::rigid},
        {"simple", dem::Fidelity::simple},
        {"standard", dem::Fidelity::standard},
        {"zones", dem::Fidelity::zones},
        {"fine", dem::Fidelity::fine}};
    for (const auto& [name, fidelity] : rungs)
        for (const double steps : {100.0, 200.0, 500.0, 1000.0, 2000.0}) {
            all.push_back(setting(name, fidelity, steps));
            all.back().is_default = all.back().solver == dem::SolverOptions{} &&
                                    all.back().discretisation == dem::Discretisation{};
        }
}

void add_points(std::vector<Setting>& all)
{
    for (const int n : {3, 4, 6, 8}) {
        all.push_back(setting("contact points", dem::Fidelity::standard, 1000));
        all.back().discretisation.contact_points = n;
    }
    for (const int n : {3, 5, 9}) {
        all.push_back(setting("even points", dem::Fidelity::standard, 1000));
        all.back().discretisation.contact_points = n;
        all.back().discretisation.face_rule = dem::FaceRule::even;
    }
}

void add_drive(std::vector<Setting>& all)
{
    for (const double limit : {0.01, 0.003, 0.0003}) {
        all.push_back(setting("unbalance limit", dem::Fidelity::standard, 1000));
        all.back().solver.unbalance_limit = limit;
    }
    for (const double steps : {200.0, 1000.0, 5000.0}) {
        all.push_back(setting("constant speed", dem::Fidelity::standard, steps));
        all.back().solver.unbalance_limit = 0.0;
    }
}

void add_damping(std::vector<Setting>& all)
{
    for (const double gamma : {0.3, 0.5, 0.7, 0.9}) {
        all.push_back(setting("damping factor", dem::Fidelity::standard, 1000));
        all.back().solver.damping_factor = gamma;
    }
    for (const double steps : {1000.0, 4000.0, 16000.0}) {
        all.push_back(setting("local damping", dem::Fidelity::standard, steps));
        all.back().solver.damping = dem::Damping::local;
        all.back().solver.unbalance_limit = 0.0;
    }
}

void add_arithmetic(std::vector<Setting>& all)
{
    for (const double steps : {500.0, 1000.0}) {
        all.push_back(setting("one wall at a time", dem::Fidelity::standard, steps));
        all.back().workers.scalar = true;
    }
}

void add_nodal(std::vector<Setting>& all)
{
    for (const double steps : {1500.0, 6000.0, 20000.0}) {
        all.push_back(setting("paper's scheme", dem::Fidelity::zones, steps));
        all.back().nodal_steps_per_mm = steps;
    }
}

} // namespace

std::vector<Setting> settings()
{
    std::vector<Setting> all;
    add_ladder(all);
    add_points(all);
    add_drive(all);
    add_damping(all);
    add_arithmetic(all);
    add_nodal(all);
    return all;
}

} // namespace bench
