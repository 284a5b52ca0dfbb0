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
    Choice{"strut", "load by a strut of 2 m above"},
    Choice{"tendon", "load by a tendon of 1.1 m, to the floor"},
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

/// A limit drift of each wall. @param limit where the wall reached it
template <class Limit>
fragility::KaplanMeier drifts(const std::vector<const app::StudyWall*>& walls, double height,
                              Limit limit)
{
    std::vector<fragility::Observation> all;
    for (const app::StudyWall* w : walls) {
        const fragility::LimitDisplacement& u = limit(*w);
        const double drift = u.displacement / height;
        all.push_back(app::is_observed(u) ? fragility::observed(drift)
                                          : fragility::right_censored(drift));
    }
    return fragility::kaplan_meier(all);
}

const fragility::LimitDisplacement& ultimate(const app::StudyWall& w)
{
    return w.reading.ultimate;
}
const fragility::LimitDisplacement& collapse(const app::StudyWall& w)
{
    return w.reading.collapse;
}

/// Walls of a mode, or of all modes (-1).
std::vector<const app::StudyWall*> walls_of(const app::StudyLevel& level, int mode = -1)
{
    std::vector<const app::StudyWall*> walls;
    for (const app::StudyWall& w : level.walls)
        if (mode < 0 || app::mode_of(w) == mode) walls.push_back(&w);
    return walls;
}

app::Row row(const char* name, const app::StudyWalls& study, const app::StudyLevel& level)
{
    const double n = static_cast<double>(level.walls.size());
    double force = 0.0, stood = 0.0;
    for (const app::StudyWall& w : level.walls) {
        force += app::peak_force(w.reading) * 1e-3;
        stood += app::is_observed(w.reading.ultimate) ? 0.0 : 1.0;
    }
    std::string shares;
    for (const int mode : {app::kRocking, app::kSliding, app::kMixed})
        shares += (shares.empty() ? "" : " / ") +
                  app::fixed(100.0 * static_cast<double>(walls_of(level, mode).size()) / n, 0);
    const fragility::KaplanMeier km = drifts(walls_of(level), study.height, ultimate);
    return {app::fixed(level.stress * 1e-6, 2),
            name,
            app::fixed(force / n, 1),
            shares,
            quantile_text(km, 0.16),
            quantile_text(km, 0.50),
            quantile_text(km, 0.84),
            app::fixed(100.0 * stood / n, 0),
            std::to_string(level.failed_walls.size())};
}

/// @throws std::runtime_error if walls are missing
app::StudyWalls complete(const fs::path& work, const char* name)
{
    app::StudyWalls study = app::read_study_walls(work / (std::string(name) + ".h5"));
    for (const app::StudyLevel& level : study.levels)
        if (level.missing > 0)
            throw std::runtime_error(study.name +
                                     " has not all its walls; run bench/limits.sh again");
    return study;
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
    for (const Choice& c : choices) all.push_back(complete(work, c.file));
    for (std::size_t l = 0; l < all.front().levels.size(); ++l)
        for (std::size_t c = 0; c < kN; ++c)
            t.rows.push_back(row(choices[c].name, all[c], all[c].levels.at(l)));
    return t;
}

/// Where walls of each mode have lost 20 % of their force, and all of it.
app::Table by_mode(const fs::path& work)
{
    constexpr std::size_t kFewest = 5;
    app::Table t;
    t.caption = "Finite displacements, load that moves with the beam, pushed until no force is "
                "left: drifts by mode, five walls or more.";
    t.head = {"stress [MPa]",
              "mode",
              "walls",
              "80 %: 16 % of walls [%]",
              "median [%]",
              "84 % [%]",
              "zero force: 16 %",
              "median [%]",
              "84 % [%]"};
    const app::StudyWalls study = complete(work, "collapse");
    for (const app::StudyLevel& level : study.levels)
        for (const int mode : {app::kRocking, app::kSliding, app::kMixed}) {
            const auto walls = walls_of(level, mode);
            if (walls.size() < kFewest) continue;
            app::Row r = {app::fixed(level.stress * 1e-6, 2), app::mode_name(mode),
                          std::to_string(walls.size())};
            for (const auto limit : {ultimate, collapse})
                for (const double p : {0.16, 0.50, 0.84})
                    r.push_back(quantile_text(drifts(walls, study.height, limit), p));
            t.rows.push_back(r);
        }
    return t;
}

std::string page_of(const fs::path& work)
{
    return "# What decides how far a wall can be pushed\n\nWritten by `bash bench/limits.sh` "
           "on " +
           bench::machine_line() +
           ". The walls of `configs/collapse.ini`, 50 under each stress (16 where the density "
           "of "
           "cracks is at issue), the same samples in each row, pushed until the force has come "
           "down to 80 % of its peak. Drift limits: "
           "where it does, over the height of the load, by Kaplan and Meier, with 95 % "
           "intervals; a number behind > says that fewer walls than this share fell to "
           "80 % before their push ended. What the tables show: "
           "[model.md](model.md#limits).\n\n" +
           app::as_markdown(
               table(work, kChoices,
                     "Kinematics, vertical load, crushing and cracks at the toe, one "
                     "at a time.")) +
           "\n" + app::as_markdown(by_mode(work)) + "\n" +
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
