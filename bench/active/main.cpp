#include "bench/active/problems.hpp"
#include "uq/reliability/active_learning.hpp"
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
int main(int argc, char** argv)
{
    const int reps = argc > 1 ? std::atoi(argv[1]) : 5;
    const int only = argc > 2 ? std::atoi(argv[2]) : -1;
    const double target = argc > 3 ? std::atof(argv[3]) : 0.1;
    const bool verbose = argc > 4;
    int i = -1;
    for (const auto& p : active_bench::bench_problems()) {
        if (++i, only >= 0 && i != only) continue;
        int held = 0;
        double calls = 0, bias = 0, sq = 0, se = 0, sur = 0, learned = 0;
        const std::clock_t t0 = std::clock();
        int reached = 0;
        for (int r = 0; r < reps; ++r) {
            uq::ActiveOptions o;
            o.seed = 1 + r;
            o.target_cov = target;
            o.max_evaluations = 600;
            const auto a = uq::active_learning(p.limit, o);
            const auto& e = a.exceedance.estimate;
            held += e.interval.lower <= p.exact && p.exact <= e.interval.upper;
            calls += a.exceedance.ledger.evaluations;
            learned += a.learned;
            const double err = e.value / p.exact - 1;
            bias += err;
            sq += err * err;
            se += e.std_error / p.exact;
            sur += a.surprises;
            reached += a.exceedance.outcome == uq::SamplingOutcome::target_reached;
            if (verbose)
                std::printf(
                    "   %d: %g (%g) [%g %g] sur %g calls %zu learned %zu surprises %zu %s\n", r,
                    e.value, e.std_error, e.interval.lower, e.interval.upper, a.surrogate,
                    a.exceedance.ledger.evaluations, a.learned, a.surprises, a.trouble.c_str());
        }
        std::printf("%2d %-34s exact %.4e calls %.0f learned %.0f bias %.2f%% rms %.2f%% se "
                    "%.2f%% held %d/%d surprises %.1f reached %d  %.1f s each\n",
                    i, p.name.c_str(), p.exact, calls / reps, learned / reps, 100 * bias / reps,
                    100 * std::sqrt(sq / reps), 100 * se / reps, held, reps, sur / reps,
                    reached, double(std::clock() - t0) / CLOCKS_PER_SEC / reps);
        std::fflush(stdout);
    }
}
