#include "dem/solver/state/elastic_operator.hpp"

#include "dem/solver/state/closing_joint.hpp"

#include <cstddef>

namespace dem {

void stretch(const StepTables& t, const std::vector<double>& q, std::vector<double>& du)
{
    du.assign(du.size(), 0.0);
    for (const auto& b : t.blocks)
        scatter(t.matrices[b.element], t.port_contact.data() + b.first_port,
                q.data() + b.first_mode, du.data());
}

void elastic_stress(const StepTables& t, const WallState<double>& s,
                    const std::vector<double>& du, std::vector<double>& stress)
{
    const auto fill = [&](const std::vector<ContactRun>& runs, const auto& laws) {
        for (const ContactRun& run : runs)
            for (int k = run.first; k < run.first + run.count; ++k) {
                stress[2 * k] = laws[run.law].kn * du[2 * k];
                stress[2 * k + 1] = laws[run.law].ks * du[2 * k + 1];
            }
    };
    if (s.laws.closure == Closure::linear)
        fill(t.dry, s.laws.dry);
    else
        with_closure(s.laws, [&]<Closure kClosure, bool>() {
            for (const ContactRun& run : t.dry)
                for (int k = run.first; k < run.first + run.count; ++k) {
                    const auto [kn, ks] = stiffness_of<kClosure>(s, run.law, k);
                    stress[2 * k] = kn * du[2 * k];
                    stress[2 * k + 1] = ks * du[2 * k + 1];
                }
        });
    fill(t.tied, s.laws.tied);
    fill(t.cracks, s.laws.cracks);
}

void apply_stiffness(const StepTables& t, const std::vector<double>& q, WallState<double>& s,
                     std::vector<double>& kq)
{
    stretch(t, q, s.du);
    elastic_stress(t, s, s.du, s.stress);
    for (const auto& b : t.blocks) {
        double* force = kq.data() + b.first_mode;
        gather(t.matrices[b.element], t.port_contact.data() + b.first_port, t.area.data(),
               s.stress.data(), force);
        for (int i = 0; i < b.modes; ++i)
            force[i] = s.laws.elasticity[b.first_mode + i] * q[b.first_mode + i] - force[i];
    }
}

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

} // namespace dem
