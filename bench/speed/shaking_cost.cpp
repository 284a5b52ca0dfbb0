/// shaking_cost RECORDS [OUT.md]: cost and error of histories of the paper's wall under the
/// first 20 s of each record of a folder, one thread, a register of walls.

#include "app/output/table/table.hpp"
#include "app/text/number_text.hpp"
#include "bench/report.hpp"
#include "bench/speed/step_time.hpp"
#include "dem/contact/pack.hpp"
#include "dem/shaking/shake_ensemble.hpp"
#include "ground/record.hpp"
#include "scenes/paper_wall.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr double kLength = 20.0;    // of each record [s]
constexpr double kCorrection = 1.0; // the cut record comes to rest within this time [s]
constexpr double kQuiet = 1e-4;     // as in studies

/// The beginning of a record; a hat of acceleration at its end takes the velocity that is left.
ground::GroundMotion beginning(ground::GroundMotion m)
{
    const auto most = static_cast<std::size_t>(std::lround(kLength / m.step)) + 1;
    if (m.acceleration.size() > most) m.acceleration.resize(most);
    std::vector<double>& a = m.acceleration;
    a.front() = a.back() = 0.0;
    double velocity = 0.0, area = 0.0;
    for (const double x : a) velocity += x * m.step;
    const auto n = std::min(a.size(), static_cast<std::size_t>(kCorrection / m.step));
    const auto hat = [n](std::size_t i) {
        return 1.0 -
               std::abs(2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 1.0);
    };
    for (std::size_t i = 0; i < n; ++i) area += hat(i) * m.step;
    for (std::size_t i = 0; i < n; ++i) a[a.size() - n + i] -= velocity / area * hat(i);
    return m;
}

/// Records of a folder, two columns of time and acceleration each.
std::vector<ground::GroundMotion> motions_of(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".txt") files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<ground::GroundMotion> all;
    for (const fs::path& file : files)
        all.push_back(beginning(ground::read_records(file.string()).front().motion));
    if (all.empty())
        throw std::runtime_error(folder.string() + " holds no .txt of two columns");
    return all;
}

struct Setting {
    const char* name;
    double damping, fraction; ///< of contacts; of the stable step [-]
};

scenes::Scene floor_wall()
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.loads.pattern = dem::LoadPattern::body;
    s.wall.toe = dem::Toe::free;
    return s;
}

std::vector<dem::ShakeResult> histories(const std::vector<ground::GroundMotion>& motions,
                                        const Setting& setting)
{
    const scenes::Scene s = floor_wall();
    const dem::Model model = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::simple));
    std::vector<dem::ShakeResult> all(motions.size());
    dem::ShakenEnsemble e;
    e.size = motions.size();
    e.damps = setting.damping > 0.0;
    e.history = [&](std::size_t i) {
        dem::HistoryInput in{scenes::uniform(s, model), {}};
        in.plan.step = motions[i].step;
        in.plan.horizontal = motions[i].acceleration;
        in.plan.load = dem::LoadMass::floor;
        in.plan.quiet = kQuiet;
        in.plan.contact_damping = setting.damping;
        in.plan.step_fraction *= setting.fraction;
        return in;
    };
    e.done = [&](std::size_t i, dem::ShakeResult&& r) { all[i] = std::move(r); };
    dem::shake_ensemble(model, e, {}, {.threads = 1});
    return all;
}

double quantile_of(std::vector<double> x, double p)
{
    std::ranges::sort(x);
    return x[static_cast<std::size_t>(p * static_cast<double>(x.size() - 1) + 0.5)];
}

/// Largest drifts [%]; a wall that fell went farther than any other.
std::vector<double> drifts_of(const std::vector<dem::ShakeResult>& all)
{
    constexpr double kFell = 100.0;
    std::vector<double> drifts;
    for (const dem::ShakeResult& r : all)
        drifts.push_back(r.outcome == dem::ShakeOutcome::collapsed
                             ? kFell
                             : 100.0 * r.most_displacement / r.top_height);
    return drifts;
}

/// Largest distance between the shares of walls that went as far (Kolmogorov and Smirnov).
double distance(const std::vector<double>& a, const std::vector<double>& b)
{
    const auto share = [](const std::vector<double>& all, double x) {
        const auto n = std::ranges::count_if(all, [x](double y) { return y <= x; });
        return static_cast<double>(n) / static_cast<double>(all.size());
    };
    double most = 0.0;
    for (const auto* all : {&a, &b})
        for (const double x : *all) most = std::max(most, std::abs(share(a, x) - share(b, x)));
    return most;
}

app::Row row_of(const Setting& setting, const std::vector<dem::ShakeResult>& all,
                const std::vector<double>& reference)
{
    double seconds = 0.0, shaken = 0.0, steps = 0.0, worst = 0.0;
    std::vector<double> balance;
    int fell = 0, again = 0;
    for (const dem::ShakeResult& r : all) {
        seconds += r.seconds;
        shaken += r.end;
        steps += static_cast<double>(r.steps);
        balance.push_back(r.residual);
        worst = std::max(worst, r.residual);
        fell += r.outcome == dem::ShakeOutcome::collapsed ? 1 : 0;
        again += r.step_reductions > 0 ? 1 : 0;
    }
    const std::vector<double> drifts = drifts_of(all);
    const auto drift = [&](double p) {
        const double x = quantile_of(drifts, p);
        return x >= 100.0 ? std::string("fell") : app::fixed(x, 2);
    };
    return {setting.name,
            app::fixed(1e6 * all.front().time_step, 1),
            app::fixed(shaken, 0),
            app::fixed(1e-6 * steps, 1),
            app::fixed(seconds, 0),
            app::fixed(1e6 * seconds / steps, 2),
            app::fixed(100.0 * quantile_of(balance, 0.5), 3),
            app::fixed(100.0 * worst, 2),
            std::to_string(again),
            std::to_string(fell),
            drift(0.16),
            drift(0.5),
            drift(0.84),
            app::fixed(distance(drifts, reference), 2)};
}

/// A step of the same wall while its beam is pushed, in the same register [us for each wall].
double pushed_step()
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model model = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::simple));
    dem::SolverOptions options;
    options.kinematics = dem::Kinematics::finite;
    const dem::WallMaterials wall = scenes::uniform(s, model);
    const double step = bench::step_time<dem::Pack>(model, dem::step_tables(model), options,
                                                    [&](int) { return wall; });
    return 1e6 * step / dem::lanes<dem::Pack>;
}

int run(const fs::path& records, const fs::path& out)
{
    constexpr Setting kSettings[] = {{"half the step, damping 0.02", 0.02, 0.5},
                                     {"damping 0.02", 0.02, 1.0},
                                     {"half the step, no damping", 0.0, 0.5},
                                     {"no damping, the default", 0.0, 1.0}};
    const std::vector<ground::GroundMotion> motions = motions_of(records);
    bench::Section section;
    section.table.head = {"setting",
                          "step [us]",
                          "history [s]",
                          "steps [1e6]",
                          "core [s]",
                          "a step of a wall [us]",
                          "balance median [%]",
                          "balance worst [%]",
                          "smaller step",
                          "fell",
                          "drift 16 % [%]",
                          "drift 50 % [%]",
                          "drift 84 % [%]",
                          "distance to half the step [-]"};
    std::vector<double> reference;
    for (const Setting& s : kSettings) {
        const std::vector<dem::ShakeResult> all = histories(motions, s);
        if (s.fraction < 1.0) reference = drifts_of(all);
        section.table.rows.push_back(row_of(s, all, reference));
        app::Table one = section.table;
        one.rows = {section.table.rows.back()};
        std::cerr << app::as_text(one);
    }
    const bench::Report report{
        "Cost of histories",
        std::to_string(motions.size()) +
            " records, their first 20 s, one thread. The paper's wall, 0.50 "
            "MPa of a floor, fidelity simple. A step of the same wall that is "
            "pushed with finite displacements takes " +
            app::fixed(pushed_step(), 2) +
            " us in the same register. Two samples of 44 of one distribution "
            "are 0.29 apart at most in 95 of 100 cases.",
        {section}};
    if (out.empty())
        std::cout << bench::as_markdown(report);
    else
        bench::write_report(out, report);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2 || argc > 3) {
        std::cerr << "usage: shaking_cost RECORDS [OUT.md]\n";
        return 2;
    }
    try {
        return run(argv[1], argc == 3 ? argv[2] : "");
    } catch (const std::exception& bad) {
        std::cerr << bad.what() << "\n";
        return 1;
    }
}
