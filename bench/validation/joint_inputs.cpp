#include "bench/validation/joint_inputs.hpp"

#include "app/input/number_text.hpp"
#include "bench/validation/cells.hpp"
#include "bench/validation/paper_tables.hpp"

#include <array>
#include <cstddef>

namespace bench {
namespace {

struct Study {
    const char* file;
    const char* name;
};

constexpr std::array kStudies = {
    Study{"joint/none.h5", "none: mean values, one wall"},
    Study{"joint/joint_friction.h5", "friction of joints"},
    Study{"joint/joint_stiffness.h5", "stiffness of joints"},
    Study{"joint/unit_strength.h5", "tensile strength of units"},
    Study{"joint/unit_friction.h5", "friction of units"},
    Study{"joint/unit_stiffness.h5", "stiffness of units"},
    Study{"spatial.h5", "all five"},
    Study{"joint/more_scatter.h5", "all five, friction of joints with COV 0.30 (0.20)"}};

constexpr std::size_t kNone = 0, kFriction = 1, kAll = 6, kMoreScatter = 7;

double mean(const std::vector<JointInput>& inputs, std::size_t i)
{
    return inputs.at(i).walls.peak_kN.mean;
}

std::string kilonewton(double force) { return app::fixed(force, 1) + " kN"; }

std::string percent_rocking(const LevelStatistics& s)
{
    return app::fixed(
               100.0 * static_cast<double>(s.rocking_walls) / static_cast<double>(s.walls), 0) +
           " %";
}

} // namespace

std::vector<JointInput> joint_inputs(const std::filesystem::path& work)
{
    std::vector<JointInput> inputs;
    for (const Study& s : kStudies)
        inputs.push_back(
            {s.name, level_statistics(app::read_study_walls(work / s.file, {})).front()});
    return inputs;
}

app::Table joint_inputs_table(const std::vector<JointInput>& inputs)
{
    app::Table t;
    t.caption =
        "Which input makes the fall: each alone with a value per joint (stratified), the "
        "others at their means, 100 walls each. [95 % intervals].";
    t.head = {"random, per joint", "rocking [%]", "force, all [kN]", "COV of all",
              "displacement, mixed [mm]"};
    for (const JointInput& i : inputs) {
        const LevelStatistics& s = i.walls;
        const bool one = s.walls == 1;
        t.rows.push_back({i.name, one ? "" : share_cell(s.rocking_walls, s.walls),
                          one ? app::fixed(s.peak_kN.mean, 2) : with_interval(s.peak_kN, 2),
                          one ? "" : app::fixed(s.peak_kN.cov(), 3),
                          one ? app::fixed(s.mixed.displacement_mm.mean, 1)
                              : with_interval(s.mixed.displacement_mm, 1)});
    }
    return t;
}

std::string remark_on_joint_inputs(const std::vector<JointInput>& inputs)
{
    return "A wall of mean values carries " + kilonewton(mean(inputs, kNone)) +
           "; friction alone, per joint, " + kilonewton(mean(inputs, kFriction)) +
           ", all five " + kilonewton(mean(inputs, kAll)) + ", in the paper " +
           kilonewton(pooled_peak(kPaperSpatial)) +
           ". Friction that scatters half as much again would give " +
           kilonewton(mean(inputs, kMoreScatter)) + ", but with " +
           percent_rocking(inputs.at(kMoreScatter).walls) + " of rocking walls instead of " +
           percent_rocking(inputs.at(kAll).walls) + " (paper: 12 %).";
}

} // namespace bench
