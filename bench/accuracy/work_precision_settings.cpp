#include "bench/accuracy/work_precision.hpp"

namespace bench {

namespace {

Setting setting(std::string family, dem::Fidelity fidelity = dem::Fidelity::standard)
{
    Setting s;
    s.family = std::move(family);
    s.fidelity = fidelity;
    s.discretisation = dem::discretisation_of(fidelity);
    return s;
}

Setting at_constant_speed(std::string family, double steps_per_mm)
{
    Setting s = setting(std::move(family));
    s.solver.unbalance_limit = 0.0;
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
        for (const double accuracy : {0.1, 0.03, 0.01, 0.003, 0.001}) {
            all.push_back(setting(name, fidelity));
            all.back().solver.accuracy = accuracy;
            all.back().is_default = all.back().solver == dem::SolverOptions{} &&
                                    all.back().discretisation == dem::Discretisation{};
        }
}

void add_points(std::vector<Setting>& all)
{
    for (const int n : {3, 4, 6, 8}) {
        all.push_back(setting("contact points"));
        all.back().discretisation.contact_points = n;
    }
    for (const int n : {3, 5, 9}) {
        all.push_back(setting("even points"));
        all.back().discretisation.contact_points = n;
        all.back().discretisation.face_rule = dem::FaceRule::even;
    }
}

void add_drive(std::vector<Setting>& all)
{
    for (const double limit : {1.0, 0.3, 0.1}) {
        all.push_back(setting("unbalance limit"));
        all.back().solver.unbalance_limit = limit;
    }
    for (const double steps : {200.0, 1000.0, 5000.0})
        all.push_back(at_constant_speed("constant speed", steps));
}

void add_damping(std::vector<Setting>& all)
{
    for (const double gamma : {0.3, 0.5, 0.7, 0.9}) {
        all.push_back(setting("damping factor"));
        all.back().solver.damping_factor = gamma;
    }
    for (const double steps : {1000.0, 4000.0, 16000.0}) {
        all.push_back(at_constant_speed("local damping", steps));
        all.back().solver.damping = dem::Damping::local;
    }
}

void add_arithmetic(std::vector<Setting>& all)
{
    for (const double accuracy : {0.03, 0.01}) {
        all.push_back(setting("one wall at a time"));
        all.back().solver.accuracy = accuracy;
        all.back().workers.scalar = true;
    }
}

void add_nodal(std::vector<Setting>& all)
{
    for (const double steps : {1500.0, 6000.0, 20000.0}) {
        all.push_back(setting("paper's scheme", dem::Fidelity::zones));
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
