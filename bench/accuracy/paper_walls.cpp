/// paper_walls OUT.md: the paper's 350 walls in one run; the error of drive and step, wall by
/// wall; the error of the discretisation, on ensembles.

#include "app/output/atomic_output.hpp"
#include "app/output/table/table.hpp"
#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace {

using bench::Answer;
using bench::Case;

const std::vector<double> kStress = {0.15, 0.50, 0.75, 1.00, 1.25}; // [MPa]

std::vector<Case> walls(double stress, int n, bool spatial = false)
{
    std::vector<Case> cases(n);
    for (int i = 0; i < n; ++i) {
        cases[i].scene = scenes::paper_wall(stress);
        cases[i].sample = i;
        cases[i].spatial = spatial;
    }
    return cases;
}

void append(std::vector<Case>& all, const std::vector<Case>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

double quantile(std::vector<double> values, double p)
{
    std::sort(values.begin(), values.end());
    const double at = p * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

std::string percent(double share, int digits = 2) { return app::fixed(100.0 * share, digits); }

/// Readings of an ensemble.
struct Reading {
    bench::Moments force, d80; ///< d80: of the walls that dropped
    int n = 0, mixed = 0, failed = 0;
    double residual = 0.0, steps = 0.0;
};

Reading read(const Answer* a, int n)
{
    Reading r;
    r.n = n;
    std::vector<double> peaks, drops;
    for (int i = 0; i < n; ++i) {
        r.failed += a[i].failed;
        if (a[i].failed) continue;
        peaks.push_back(a[i].peak);
        if (!a[i].censored) drops.push_back(a[i].ultimate);
        r.mixed += a[i].mixed;
        r.residual = std::max(r.residual, a[i].residual);
        r.steps += static_cast<double>(a[i].steps) / n;
    }
    r.force = bench::moments(peaks);
    r.d80 = bench::moments(drops);
    return r;
}

std::string all_walls()
{
    std::vector<Case> cases;
    for (const double stress : kStress) append(cases, walls(stress, 50));
    append(cases, walls(0.75, 100, true));
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Answer> answers = bench::run_all(cases);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

    app::Table t;
    t.head = {"walls",         "n",       "mean F [kN]", "COV F",  "dropped",
              "mean d80 [mm]", "COV d80", "mixed",       "failed", "steps per wall",
              "residual [%]"};
    const auto add = [&t](const std::string& name, const Reading& r) {
        t.rows.push_back({name, std::to_string(r.n), app::fixed(r.force.mean * 1e-3, 2),
                          app::fixed(r.force.cov, 3), std::to_string(r.d80.n),
                          r.d80.n > 1 ? app::fixed(r.d80.mean * 1e3, 2) : "",
                          r.d80.n > 1 ? app::fixed(r.d80.cov, 2) : "", std::to_string(r.mixed),
                          std::to_string(r.failed), app::fixed(r.steps, 0),
                          percent(r.residual)});
    };
    for (std::size_t i = 0; i < kStress.size(); ++i)
        add(app::fixed(kStress[i], 2) + " MPa", read(&answers[50 * i], 50));
    add("0.75 MPa, spatial", read(&answers[250], 100));
    std::cerr << "350 walls: " << seconds.count() << " s\n";
    return "\n## 350 walls\n\nAll at default settings, in one run, the discretisation of the "
           "wall "
           "included: **" +
           app::fixed(seconds.count(), 1) + " s**.\n\n" + app::as_markdown(t);
}

constexpr double kNoDrop = 1.0; // [m]: stands for the displacement of a drop that does not come

double drop_of(const Answer& a) { return a.censored ? kNoDrop : a.ultimate; }

double middle(double a, double b, double c)
{
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// The middle answer of three slow runs.
Answer middle(const Answer& a, const Answer& b, const Answer& c)
{
    Answer m = a;
    m.peak = middle(a.peak, b.peak, c.peak);
    m.ultimate = middle(drop_of(a), drop_of(b), drop_of(c));
    m.censored = m.ultimate == kNoDrop;
    m.mixed = a.mixed + b.mixed + c.mixed >= 2;
    return m;
}

/// Wall by wall against the limit.
struct Errors {
    std::vector<double> peak;
    int close = 0, same = 0;
};

void compare(const Answer& a, const Answer& limit, Errors& e)
{
    e.peak.push_back(std::abs(a.peak / limit.peak - 1.0));
    e.close += std::abs(drop_of(a) - drop_of(limit)) <= 0.3e-3;
    e.same += a.mixed == limit.mixed;
}

app::Row cells(const std::string& name, const std::string& stress, const Errors& e)
{
    const double walls = static_cast<double>(e.peak.size());
    return {name,
            stress,
            std::to_string(e.peak.size()),
            percent(quantile(e.peak, 0.5)),
            percent(quantile(e.peak, 0.95)),
            percent(quantile(e.peak, 1.0)),
            percent(e.close / walls, 1),
            percent(e.same / walls, 1)};
}

/// Default settings against the slow limit at the same discretisation.
std::string drive_error(int n)
{
    std::vector<Case> cases;
    for (const double stress : kStress) append(cases, walls(stress, n));
    std::vector<std::vector<Answer>> runs = {bench::run_all(cases)};
    for (const double accuracy : {0.001, 0.0009, 0.0008}) {
        for (Case& c : cases) c.solver.accuracy = accuracy;
        runs.push_back(bench::run_all(cases));
    }
    app::Table t;
    t.head = {"run",
              "stress [MPa]",
              "walls",
              "median dF [%]",
              "95 % dF [%]",
              "largest dF [%]",
              "d80 within 0.3 mm [%]",
              "the same mode [%]"};
    const char* names[] = {"default", "0.1 %", "0.09 %", "0.08 %"};
    for (std::size_t run = 0; run < runs.size(); ++run) {
        Errors all;
        for (std::size_t level = 0; level < kStress.size(); ++level) {
            Errors here;
            for (std::size_t i = n * level; i < n * (level + 1); ++i) {
                const Answer limit = middle(runs[1][i], runs[2][i], runs[3][i]);
                compare(runs[run][i], limit, here);
                compare(runs[run][i], limit, all);
            }
            if (run == 0)
                t.rows.push_back(cells(names[run], app::fixed(kStress[level], 2), here));
        }
        t.rows.push_back(cells(names[run], "all", all));
    }
    return "\n## Error of drive and step\n\nThe same walls, wall by wall, against the slow "
           "limit at "
           "the same discretisation: the middle of three slow runs (accuracy 0.1, 0.09 and "
           "0.08 %). Three, because a wall whose drop just touches 80 %, "
           "or where "
           "two units are about to crack, goes one way or the other at any speed: the last "
           "rows say how "
           "far the slow runs agree. d80 counts as close if both walls drop within 0.3 mm, or "
           "neither "
           "drops.\n\n" +
           app::as_markdown(t);
}

/// Rungs of the ladder against the finest, as distributions.
std::string discretisation_error(int n)
{
    struct Rung {
        const char* name;
        dem::Fidelity fidelity;
    };
    const std::vector<Rung> rungs = {{"rigid", dem::Fidelity::rigid},
                                     {"simple", dem::Fidelity::simple},
                                     {"standard (default)", dem::Fidelity::standard},
                                     {"zones", dem::Fidelity::zones},
                                     {"fine", dem::Fidelity::fine}};
    app::Table t;
    t.head = {"stress [MPa]", "fidelity",    "mean F [kN]",   "to fine [%]",
              "COV F",        "dropped [%]", "mean d80 [mm]", "+-",
              "to fine [%]",  "COV d80",     "mixed [%]",     "core s per wall"};
    for (const double stress : {0.75, 1.25}) {
        std::vector<Reading> readings;
        std::vector<double> cost;
        for (const Rung& rung : rungs) {
            std::vector<Case> cases = walls(stress, n);
            for (Case& c : cases) c.discretisation = dem::discretisation_of(rung.fidelity);
            std::cerr << rung.name << " at " << stress << " MPa: ";
            const std::vector<Answer> answers = bench::run_all(cases);
            readings.push_back(read(answers.data(), n));
            double seconds = 0.0;
            for (const Answer& a : answers) seconds += a.seconds;
            cost.push_back(seconds / n);
        }
        const Reading& fine = readings.back();
        for (std::size_t i = 0; i < rungs.size(); ++i) {
            const Reading& r = readings[i];
            const double error = r.d80.mean * r.d80.cov / std::sqrt(r.d80.n);
            t.rows.push_back(
                {app::fixed(stress, 2), rungs[i].name, app::fixed(r.force.mean * 1e-3, 2),
                 percent(r.force.mean / fine.force.mean - 1.0), app::fixed(r.force.cov, 3),
                 percent(static_cast<double>(r.d80.n) / n, 1), app::fixed(r.d80.mean * 1e3, 2),
                 app::fixed(error * 1e3, 2), percent(r.d80.mean / fine.d80.mean - 1.0, 1),
                 app::fixed(r.d80.cov, 2), percent(static_cast<double>(r.mixed) / n, 1),
                 app::fixed(cost[i], 3)});
        }
    }
    return "\n## Error of the discretisation: the fidelity ladder\n\n" + std::to_string(n) +
           " walls of Table 5 (non-spatial) per row, the same samples in every row, default "
           "drive. "
           "The post-peak branches wall by wall, so distributions are compared. +-: standard "
           "error of "
           "the mean over these walls.\n\n" +
           app::as_markdown(t);
}

constexpr const char* kOpening = R"(# The paper's walls

Samples of Table 5, pushed by 30 mm. F: peak force; d80:
displacement at which the force first comes down to 80 % of it, over the walls where it does ("dropped").

)";

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: paper_walls OUT.md\n";
        return 2;
    }
    std::string text = kOpening + ("Written by `" + bench::command_line()) + "` on " +
                       bench::machine_line() + ".\n";
    text += all_walls();
    text += drive_error(40);
    text += discretisation_error(200);
    app::write_file(argv[1], text);
    return 0;
}
