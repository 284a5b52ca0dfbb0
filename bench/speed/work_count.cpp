#include "bench/speed/work_count.hpp"

namespace bench {

StepWork work_of(const dem::StepTables& t)
{
    StepWork w;
    w.blocks = static_cast<long long>(t.blocks.size());
    for (const auto& b : t.blocks) {
        const long long ports = t.matrices[b.element].ports;
        w.modes += b.modes;
        w.ports += ports;
        // two products, gather and scatter; two rows per port
        w.multiply_adds += 2LL * 2LL * ports * b.modes;
    }
    for (const auto& a : t.matrices) w.matrix_bytes += static_cast<long long>(bytes_of(a));
    w.dry = t.first_tied;
    w.tied = t.first_crack - t.first_tied;
    w.cracks = t.n_contacts - t.first_crack;
    w.dry_laws = static_cast<long long>(t.dry.size() + t.tied.size());
    w.crack_laws = static_cast<long long>(t.cracks.size());
    const auto beam = static_cast<long long>(t.beam.size()),
               ground = static_cast<long long>(t.ground.size());
    w.operations = kModeOperations * w.modes + kPortOperations * w.ports +
                   kDryOperations * w.dry + kTiedOperations * w.tied +
                   kCrackOperations * w.cracks + kDriveOperations * beam +
                   kForceOperations * (beam + ground) + kStepOperations;
    return w;
}

Traffic traffic_of(const StepWork& w, std::size_t real)
{
    const auto sum = [](auto... terms) { return (static_cast<double>(terms) + ...); };
    const auto bytes = static_cast<double>(real);
    const double tables =
        sum(w.matrix_bytes) + sizeof(double) * sum(w.contacts()) + sizeof(int) * sum(w.ports);
    const double laws = bytes * sum(4 * w.dry_laws, 11 * w.crack_laws);
    Traffic t;
    // q, v, last_force, inv_mass, load, elasticity; du, stress (2 each), u_n; memory of a crack
    t.state = bytes * sum(6 * w.modes, 5 * w.contacts(), 4 * w.cracks) + laws + tables;
    // blocks: stress and du; contacts: du, tau, u_n, and of a crack u_max, secant, integrity
    t.read = bytes * sum(6 * w.modes, 4 * w.contacts(), 4 * w.contacts(), 3 * w.cracks) + laws +
             tables;
    // blocks: q, v, last_force; du. Contacts: du, stress, u_n
    t.written = bytes * sum(3 * w.modes, 2 * w.contacts(), 5 * w.contacts());
    return t;
}

} // namespace bench
