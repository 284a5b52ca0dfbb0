#include "bench/speed/law_cost.hpp"

#include "app/output/table/table.hpp"
#include "app/text/number_text.hpp"
#include "dem/contact/contact_law.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace bench {

namespace {

using dem::Pack;

constexpr int kContacts = 256; // in the first cache
constexpr int kRounds = 4000;

dem::CrackLaw<Pack> crack_law(double strength)
{
    dem::CrackLaw<Pack> law{};
    law.kn = Pack(8e10);
    law.ks = Pack(3.3e10);
    law.inv_ks = Pack(1.0 / 3.3e10);
    law.ft = law.cohesion_drop = Pack(strength);
    law.u_el = law.ft / law.kn;
    law.inv_softening = Pack(strength > 0.0 ? 7e4 : dem::kBreaksAtOnce);
    law.tan_phi_res = Pack(0.7);
    law.tension_weight = Pack(1.0);
    return law;
}

/// Small to and fro, in compression: no contact opens or slips.
Pack wiggle(int round) { return Pack(round % 2 == 0 ? 1e-12 : -1e-12); }

template <class Update> double nanoseconds(Update update)
{
    double best = 1e9;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        for (int round = 0; round < kRounds; ++round) update(wiggle(round));
        const std::chrono::duration<double, std::nano> time =
            std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count() / (static_cast<double>(kRounds) * kContacts));
    }
    return best;
}

double dry_cost()
{
    const dem::DryLaw<Pack> law{Pack(8e9), Pack(3.3e9), Pack(1.0 / 3.3e9), Pack(0.62)};
    std::vector<dem::DryState<Pack>> contacts(kContacts, {Pack(-1e-4), Pack(0.0)});
    Pack loss(0.0);
    const double cost = nanoseconds([&](Pack du) {
        for (auto& c : contacts) {
            const auto u = dem::advance(law, c, du, du);
            c = u.state;
            loss += u.friction;
        }
    });
    return loss[0] == 1.0 ? 0.0 : cost; // the loss is used
}

double crack_cost(double strength, bool shortcut)
{
    const dem::CrackLaw<Pack> law = crack_law(strength);
    std::vector<dem::CrackState<Pack>> contacts(kContacts, intact(law));
    for (auto& c : contacts) c.u_n = Pack(-1e-5);
    Pack loss(0.0);
    const double cost = nanoseconds([&](Pack du) {
        for (auto& c : contacts) {
            const auto trial = try_elastic(law, c, du, du);
            if (shortcut && trial.holds) {
                c.u_n = trial.u_n, c.tau = trial.tau, c.sigma = trial.sigma;
                continue;
            }
            const auto u = dem::advance<dem::ContactLaw::coupled>(law, c, du, du);
            c = u.state;
            loss += u.loss.friction + u.loss.fracture;
        }
    });
    return loss[0] == 1.0 ? 0.0 : cost;
}

} // namespace

std::string law_cost_text()
{
    app::Table t;
    t.head = {"law of a contact", "ns per register of contacts"};
    t.rows = {{"dry joint", app::fixed(dry_cost(), 1)},
              {"dry joint, if it were a crack without strength",
               app::fixed(crack_cost(0.0, false), 1)},
              {"crack, elastic trial holds", app::fixed(crack_cost(3.7e6, true), 1)},
              {"crack, full law", app::fixed(crack_cost(3.7e6, false), 1)}};
    return "\n## The law alone\n\nContacts in the first cache, one core.\n\n" +
           app::as_markdown(t);
}

} // namespace bench
