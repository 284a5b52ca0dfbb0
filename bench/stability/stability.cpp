/// stability [OUT.md] [--scenes N] [--seed S] [--threads T] [--only K] [--finite]: thousands of
/// scenes drawn far outside the paper. Every wall must end as ok, collapsed, or failed with a
/// reason; exit code 1 if one does not. --only: one scene, wall by wall. --finite: with finite
/// displacements. --laws: with joints that close, bonds and cracks of mixed modes.

#include "app/text/number_text.hpp"
#include "bench/report.hpp"
#include "bench/stability/stress_tables.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using bench::DrawnLaws;
using bench::SceneReport;

constexpr double kHang = 300.0; // [s] of one core, for one scene

struct Request {
    std::string out;
    std::uint64_t scenes = 5000, seed = 1;
    unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    std::optional<std::uint64_t> only;
    dem::Kinematics kinematics = dem::Kinematics::small;
    DrawnLaws laws = DrawnLaws::linear;
};

Request read(int argc, char** argv)
{
    Request r;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto number = [&] {
            if (++i == argc) throw std::invalid_argument(word + " needs a number");
            return std::stoull(argv[i]);
        };
        if (word == "--scenes")
            r.scenes = number();
        else if (word == "--seed")
            r.seed = number();
        else if (word == "--threads")
            r.threads = static_cast<unsigned>(number());
        else if (word == "--only")
            r.only = number();
        else if (word == "--finite")
            r.kinematics = dem::Kinematics::finite;
        else if (word == "--laws")
            r.laws = DrawnLaws::all;
        else if (word.starts_with("-") || !r.out.empty())
            throw std::invalid_argument(word);
        else
            r.out = word;
    }
    return r;
}

/// Ends the program when a scene does not come back: by processor time, so that a machine with
/// other work does not look like one.
class Watchdog {
  public:
    explicit Watchdog(unsigned threads) : at_(threads) {}
    void begin(unsigned thread, std::uint64_t scene)
    {
        const std::lock_guard lock(mutex_);
        at_[thread] = {scene, std::clock(), true};
    }
    void end(unsigned thread)
    {
        const std::lock_guard lock(mutex_);
        at_[thread].running = false;
    }
    void look()
    {
        const std::lock_guard lock(mutex_);
        const double most = kHang * static_cast<double>(at_.size()) * CLOCKS_PER_SEC;
        for (const At& a : at_)
            if (a.running && static_cast<double>(std::clock() - a.start) > most) {
                std::cerr << "\nscene " << a.scene << " hangs\n" << std::flush;
                std::_Exit(1);
            }
    }

  private:
    struct At {
        std::uint64_t scene = 0;
        std::clock_t start = 0; ///< of all threads
        bool running = false;
    };
    std::mutex mutex_;
    std::vector<At> at_;
};

std::vector<SceneReport> run_all(const Request& request)
{
    std::vector<SceneReport> reports(request.scenes);
    std::atomic<std::uint64_t> next{0};
    std::atomic<unsigned> working{request.threads};
    Watchdog dog(request.threads);
    std::vector<std::jthread> team;
    for (unsigned t = 0; t < request.threads; ++t)
        team.emplace_back([&, t] {
            for (std::uint64_t k = next++; k < request.scenes; k = next++) {
                dog.begin(t, k);
                reports[k] =
                    bench::run_stress_scene(request.seed, k, request.kinematics, request.laws);
                dog.end(t);
            }
            --working;
        });
    for (int i = 1; working > 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        dog.look();
        if (i % 20 == 0)
            std::cerr << '\r' << std::min(next.load(), request.scenes) << " of "
                      << request.scenes;
    }
    std::cerr << '\n';
    return reports;
}

int show(const SceneReport& r)
{
    std::cout << "scene " << r.number << ": " << r.scene.text << '\n';
    for (std::size_t i = 0; i < r.walls.size(); ++i) {
        const bench::WallReport& w = r.walls[i];
        std::cout << "wall " << i << ": " << bench::name_of(w.outcome)
                  << (w.spoilt ? ", spoilt" : "") << (w.settled ? "" : ", not settled")
                  << ", step halved " << w.step_reductions << " times, residual "
                  << app::number(100.0 * w.residual, 3) << " %, " << w.steps << " steps\n";
    }
    if (r.on_the_way > 0.0)
        std::cout << "on the way: step at most " << app::number(r.on_the_way, 3)
                  << " of its limit\n";
    for (const std::string& rule : r.broken_rules) std::cout << "BROKEN: " << rule << '\n';
    std::cout << app::fixed(r.seconds, 2) << " s\n";
    return r.broken_rules.empty() ? 0 : 1;
}

std::string drawn(DrawnLaws laws)
{
    std::string text =
        "Drawn at random: vertical stress 0 to 5 MPa, friction 1 to 80 degrees, joint "
        "stiffness "
        "0.1 to 1000 GPa/m, cracks 1 to 1000 times as stiff, f_T 0.01 to 50 MPa, G 0.1 to "
        "10 000 N/m, each of them scattered over up to two decades from wall to wall or from "
        "joint to joint; 1 to " +
        std::string(laws == DrawnLaws::all ? "12" : "60") +
        " courses, any bond; base, toe, beam, units with and without cracks, at mid-length, in "
        "grids, along diagonals, around random cells; two walls in five with joints that "
        "crush, "
        "one in five with units that do, at 0.01 to 100 MPa and down to 1 J/m2; both laws, "
        "both "
        "kinds of damping, 0 to 0.95; step 0.2 to 2 times the proven bound; 3 to 12 modes, 2 "
        "to 6 "
        "points per face; preload solved or ramped; monotonic and cyclic pushes of up to 6 mm, "
        "some at much too high a speed.";
    if (laws == DrawnLaws::all)
        text +=
            " Drawn last: closure hyperbolic or exponential, k_0 0.001 to 1 of the joint "
            "stiffness, V_m 1 um to 10 m, loss 0 to 0.9, largest stiffness 1 to 1000 k_0, the "
            "first two scattered as the others, walls with loss beside walls without; "
            "envelopes "
            "coulomb or hyperbolic, G_II 0 to 1 MN/m, of units and of bonds; small and finite "
            "displacements; body forces, no vertical stress, no weight.";
    return text;
}

std::string rules(const bench::CampaignSums& s, DrawnLaws laws)
{
    std::string text =
        "Rules, for every wall: it ends as ok, collapsed, or failed with a reason; no number "
        "of a "
        "wall that did not fail is NaN or infinite; the energy residual of a wall called ok is "
        "below 1 %; no wall is pushed with a step above its measured limit of stability; in " +
        std::to_string(s.compared_scenes) +
        " scenes one wall had absurd values (1e300, infinite, 1e-310) and its neighbours must "
        "give the same bits without it";
    if (laws == DrawnLaws::all)
        text +=
            "; " + std::to_string(s.alone) +
            " walls were pushed alone besides, to the same bits; of " +
            std::to_string(s.on_the_way) +
            " walls whose joints close the limit was measured at seven times on the way there "
            "and back, with joints that turn where closing loses energy";
    return text + ". ";
}

std::string opening(const bench::CampaignSums& s, const Request& request)
{
    using app::fixed;
    const auto count = [](auto n) { return std::to_string(n); };
    return count(s.scenes) +
           (request.kinematics == dem::Kinematics::finite ? " scenes with finite displacements"
                                                          : " scenes") +
           " (seed " + count(request.seed) + "), " + count(s.walls) + " walls, " +
           fixed(1e-6 * static_cast<double>(s.steps), 1) + " million steps in " +
           fixed(s.seconds, 0) + " core s, " + fixed(s.walls / s.seconds, 0) +
           " walls/s and core.\n\n" + drawn(request.laws) + "\n\n" + rules(s, request.laws) +
           "**Broken rules: " + count(s.broken_rules) +
           ".**\n\nLargest energy residual of a wall called ok: " +
           fixed(100.0 * s.residual, 2) + " %. Slowest scene: " + fixed(s.slowest, 1) + " s. " +
           (request.laws == DrawnLaws::all
                ? "Step of a joint that closes on its way, at most: " +
                      fixed(s.most_on_the_way, 3) + " of its measured limit."
                : count(s.beyond_bound) +
                      " walls ran with a step beyond the proven bound, the largest at " +
                      fixed(s.over_limit, 3) + " of its measured limit.");
}

bench::Report report_of(const std::vector<SceneReport>& scenes, const Request& request)
{
    bench::Report r;
    r.title = "Stability";
    r.opening = opening(bench::sums_of(scenes), request);
    r.sections = {
        {"limit", "The step used",
         "Largest eigenvalue of M^-1 K, all contacts closed, sticking and uncracked "
         "(`dem/solver/step/stability_limit`): wall of the paper at 0.50 MPa, default "
         "settings. The "
         "bound "
         "that "
         "sets the masses is proven (`dem/block/block_element.hpp`), and it is sharp.",
         bench::limit_table()},
        {"outcomes", "Outcomes", "", bench::outcome_table(scenes)},
        {"reductions", "Step too large: halved, and the wall pushed anew",
         "Beyond the bound the limit is measured first; whatever makes energy later is found "
         "by "
         "the ledger.",
         bench::reduction_table(scenes)},
        {"within_bound", "Halved although within the bound",
         "The bound holds while contacts stay closed. One that opens and closes at speed gets "
         "its "
         "whole kick in one step: it can rebound faster than it came once (1 + gamma) omega^2 "
         "> 3, "
         "a step above 0.87 of the limit. Damping elsewhere in the wall makes up for it. Walls "
         "driven at 100 steps per mm or more.",
         bench::within_bound_table(scenes)},
        {"failed", "Failed",
         "`stability --seed S --only SCENE` (with `--finite` and `--laws` where they were) "
         "runs one again, "
         "wall by wall.",
         bench::failed_table(scenes)}};
    return r;
}

} // namespace

int main(int argc, char** argv)
try {
    const Request request = read(argc, argv);
    if (request.only)
        return show(bench::run_stress_scene(request.seed, *request.only, request.kinematics,
                                            request.laws));
    const std::vector<SceneReport> scenes = run_all(request);
    const bench::Report report = report_of(scenes, request);
    if (request.out.empty())
        std::cout << bench::as_markdown(report);
    else
        bench::write_report(request.out, report);
    return bench::sums_of(scenes).broken_rules == 0 ? 0 : 1;
} catch (const std::invalid_argument& e) {
    std::cerr << e.what()
              << "\nusage: stability [OUT.md] [--scenes N] [--seed S] [--threads T] [--only K] "
                 "[--finite] [--laws]\n";
    return 2;
}
