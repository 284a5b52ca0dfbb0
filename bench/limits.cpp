/// limits WORK OUT.md: what decides how far a wall can be pushed, from the studies of bench/limits.sh.

#include "app/output/atomic_output.hpp"
#include "app/output/table.hpp"
#include "app/study/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "fragility/kaplan_meier.hpp"

#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Choice {
    const char* file;
    const char* name;
};

constexpr std::array kChoices = {
    Choice{"small", "small displacements, pushed to 30 mm"},
    Choice{"finite", "finite displacements, load moves with the beam: the base of all below"},
    Choice{"standard", "fidelity standard (simple)"},
    Choice{"fixed_line", "load on a line fixed in space"},
    Choice{"follower", "load normal to the beam"},
    Choice{"double", "beam does not turn: double bending"},
    Choice{"crushing_92", "joints crush at 92 MPa, 25 kJ/m2"},
    Choice{"crushing_57", "joints crush at 57 MPa, 25 kJ/m2"},
    Choice{"crushing_57_brittle", "joints crush at 57 MPa, 5 kJ/m2"},
    Choice{"crushing_20", "joints crush at 20 MPa, 25 kJ/m2"},
    Choice{"cracks_2x2", "units at the toe in four pieces, fidelity standard"},
    Choice{"cracks_2x2_crushing_57", "the same, joints crush at 57 MPa, 25 kJ/m2"}};

constexpr std::array kDensities = {
    Choice{"dense_mid", "mid, all units"},
    Choice{"dense_thirds", "thirds, all units"},
    Choice{"dense_2x2", "2 x 2 at the toe, mid elsewhere"},
    Choice{"dense_2x2_all", "2 x 2, all units"},
    Choice{"dense_2x2_needed", "2 x 2 where needed"},
    Choice{"dense_4x4", "4 x 4 at the toe, mid elsewhere"},
    Choice{"dense_voronoi_100", "voronoi(100 mm) at the toe, mid elsewhere"},
    Choice{"dense_voronoi_66", "voronoi(66 mm) at the toe, mid elsewhere"},
    Choice{"dense_voronoi_50", "voronoi(50 mm) at the toe, mid elsewhere"}};

/// The smallest drift at which the share of walls reaches a probability; nothing: beyond the last wall.
template <class Share>
std::optional<double> quantile(const fragility::KaplanMeier& km, double p, Share share)
{
    for (const fragility::KaplanMeierStep& s : km.steps)
        if (share(s) >= p) return s.at;
    return {};
}

std::string drift_text(std::optional<double> drift, double end)
{
    return drift ? app::fixed(100.0 * *drift, 2) : "> " + app::fixed(100.0 * end, 2);
}

/// "0.66 [0.60, 0.71]": a quantile of the drifts with its 95 % interval [%].
std::string quantile_text(const fragility::KaplanMeier& km, double p)
{
    using Step = fragility::KaplanMeierStep;
    const auto at = [&](auto share) { return drift_text(quantile(km, p, share), km.end); };
    return at([](const Step& s) { return s.probability; }) + " [" +
           at([](const Step& s) { return s.band.upper; }) + ", " +
           at([](const Step& s) { return s.band.lower; }) + "]";
}

app::Row row(const char* name, const app::StudyWalls& walls, const app::StudyLevel& level)
{
    std::vector<fragility::Observation> drifts;
    std::array<std::size_t, 3> modes{};
    double force = 0.0;
    std::size_t stood = 0;
    for (const app::StudyWall& w : level.walls) {
        const bool observed = app::is_observed(w.reading.ultimate);
        const double drift = w.reading.ultimate.displacement / walls.height;
        drifts.push_back(observed ? fragility::observed(drift)
                                  : fragility::right_censored(drift));
        ++modes[static_cast<std::size_t>(app::mode_of(w))];
        force += app::peak_force(w.reading) * 1e-3;
        stood += observed ? 0 : 1;
    }
    const double n = static_cast<double>(level.walls.size());
    const fragility::KaplanMeier km = fragility::kaplan_meier(drifts);
    std::string shares;
    for (const std::size_t count : modes)
        shares += (shares.empty() ? "" : " / ") +
                  app::fixed(100.0 * static_cast<double>(count) / n, 0);
    return {app::fixed(level.stress * 1e-6, 2),
            name,
            app::fixed(force / n, 1),
            shares,
            quantile_text(km, 0.16),
            quantile_text(km, 0.50),
            quantile_text(km, 0.84),
            app::fixed(100.0 * static_cast<double>(stood) / n, 0),
            std::to_string(level.failed_walls.size())};
}

template <std::size_t kN>
app::Table table(const fs::path& work, const std::array<Choice, kN>& choices,
                 const std::string& caption)
{
    app::Table t;
    t.caption = caption;
    t.head = {"stress [MPa]",
              "choice",
              "mean peak [kN]",
              "rocking / sliding / mixed [%]",
              "drift limit, 16 % of walls [%]",
              "median [%]",
              "84 % [%]",
              "never fell to 80 % [%]",
              "failed"};
    std::vector<app::StudyWalls> all;
    for (const Choice& c : choices) {
        all.push_back(app::read_study_walls(work / (std::string(c.file) + ".h5")));
        for (const app::StudyLevel& level : all.back().levels)
            if (level.missing > 0)
                throw std::runtime_error(all.back().name +
                                         " has not all its walls; run bench/limits.sh again");
    }
    for (std::size_t l = 0; l < all.front().levels.size(); ++l)
        for (std::size_t c = 0; c < kN; ++c)
            t.rows.push_back(row(choices[c].name, all[c], all[c].levels.at(l)));
    return t;
}

std::string page_of(const fs::path& work)
{
    return "# What decides how far a wall can be pushed\n\nWritten by `bash bench/limits.sh` "
           "on " +
           bench::machine_line() +
           ". The walls of `configs/collapse.ini`, 16 under each stress, the same samples in "
           "each "
           "row, pushed until the force has come down to "
           "80 % of its peak. Drift limits: "
           "where it does, over the height of the load, by Kaplan and Meier, with 95 % "
           "intervals; a number behind > says that fewer walls than this share fell to "
           "80 % before their push ended. What the tables show: "
           "[model.md](model.md#limits).\n\n" +
           app::as_markdown(
               table(work, kChoices,
                     "Kinematics, vertical load, crushing and cracks at the toe, one "
                     "at a time.")) +
           "\n" +
           app::as_markdown(
               table(work, kDensities, "Density of the cracks, fidelity standard."));
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::cerr << "usage: limits WORK OUT.md\n";
        return 2;
    }
    try {
        app::write_file(argv[2], page_of(argv[1]));
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "limits: " << e.what() << '\n';
        return 1;
    }
}
