/// limits WORK OUT.md: what decides how far a wall can be pushed, from the studies of
/// bench/limits.sh.

#include "app/output/atomic_output.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"
#include "bench/limit_drifts.hpp"
#include "bench/machine.hpp"

#include <array>
#include <exception>
#include <filesystem>
#include <iostream>
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
    Choice{"finite", "finite displacements, load moves with the beam: base of all rows below"},
    Choice{"accurate", "accuracy 1 % (3 %)"},
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
    t.head = bench::limit_head();
    std::vector<app::StudyWalls> all;
    for (const Choice& c : choices) all.push_back(complete(work, c.file));
    for (std::size_t l = 0; l < all.front().levels.size(); ++l)
        for (std::size_t c = 0; c < kN; ++c)
            t.rows.push_back(bench::limit_row(choices[c].name, all[c], l));
    return t;
}

std::string page_of(const fs::path& work)
{
    return "# Choices that decide how far a wall can be pushed\n\nWritten by `bash "
           "bench/limits.sh` "
           "on " +
           bench::machine_line() +
           ". The walls are those of `configs/collapse.ini`, 50 under each stress (16 in the "
           "table of the density of cracks), with the same samples in each row, pushed with an "
           "accuracy of 3 % (solver.accuracy; one row has 1 %). They are "
           "pushed until the force has fallen to 80 % of its peak. Drift limit: displacement "
           "at this fall over the height of the load, by Kaplan and Meier, with 95 % "
           "intervals. A number after > means that fewer walls than this share fell to 80 % "
           "before their push ended. [model.md](model.md#limits) says what the tables show. "
           "For walls pushed until no force is left see [validation.md](validation.md), "
           "section 8.\n\n" +
           app::as_markdown(table(work, kChoices,
                                  "Kinematics, vertical load, crushing, and cracks at the toe, "
                                  "changed one at a time.")) +
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
