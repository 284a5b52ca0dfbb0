#include "bench/validation/joint_inputs.hpp"

#include "app/text/number_text.hpp"
#include "bench/validation/cells.hpp"

#include <string>

namespace bench {

JointInputs joint_inputs(const std::filesystem::path& work)
{
    const auto read = [&](const char* file) { return read_levels(work / file).front(); };
    return {read("joint/none.h5"),
            read("joint/joint_friction.h5"),
            read("joint/joint_stiffness.h5"),
            read("joint/unit_strength.h5"),
            read("joint/unit_friction.h5"),
            read("joint/unit_stiffness.h5"),
            read("spatial.h5"),
            read("joint/more_scatter.h5"),
            read("joint/by_course.h5")};
}

app::Table joint_inputs_table(const JointInputs& inputs)
{
    app::Table t;
    t.caption = "The input that causes the fall: each input alone with a value per joint "
                "(stratified), the others at their means, 100 walls each. [95 % intervals].";
    t.head = {"random, per joint", "rocking [%]", "force, all [kN]", "COV of all",
              "displacement, mixed [mm]"};
    const LevelStatistics& one = inputs.none;
    t.rows.push_back({"none: mean values, one wall", "", app::fixed(one.peak_kN.mean, 2), "",
                      app::fixed(one.mixed.displacement_mm.mean, 1)});
    const auto add = [&](const char* name, const LevelStatistics& s) {
        t.rows.push_back({name, share_cell(s.rocking_walls, s.walls),
                          with_interval(s.peak_kN, 2), app::fixed(s.peak_kN.cov(), 3),
                          with_interval(s.mixed.displacement_mm, 1)});
    };
    add("friction of joints", inputs.joint_friction);
    add("stiffness of joints", inputs.joint_stiffness);
    add("tensile strength of units", inputs.unit_strength);
    add("friction of units", inputs.unit_friction);
    add("stiffness of units", inputs.unit_stiffness);
    add("all five", inputs.all);
    add("all five, friction of joints with COV 0.30 (0.20)", inputs.more_scatter);
    add("all five, each the same along a course", inputs.by_course);
    return t;
}

} // namespace bench
