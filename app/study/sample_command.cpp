#include "app/commands.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/replaced_file.hpp"
#include "app/output/table/cells.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/wanted_walls.hpp"

#include <filesystem>
#include <iostream>

namespace app {
namespace {

/// The units of all columns, as people read them.
std::vector<std::string_view> units_of(const SamplePlan& plan)
{
    std::vector<std::string_view> units;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        units.insert(units.end(), plan.values.inputs[i].sites, plan.inputs[i].unit);
    return units;
}

Table head_of(const GeometryInput& geometry, const SamplePlan& plan)
{
    Table t;
    t.head = {"level", "vertical_stress [MPa]", "sample"};
    if (has_layouts(geometry)) t.head.emplace_back("wall.seed");
    const std::vector<Column> columns = input_columns(plan);
    const std::vector<std::string_view> units = units_of(plan);
    for (std::size_t k = 0; k < columns.size(); ++k)
        t.head.emplace_back(columns[k].name + " [" +
                            (units[k].empty() ? "-" : std::string(units[k])) + "]");
    return t;
}

Row row(const Masonry& masonry, const LoadInput& load, const SamplePlan& plan, int level,
        int sample)
{
    const double stress = load.vertical_stress[level];
    Row cells = {count(level), Number{from_si(stress, "MPa")}, count(sample)};
    if (has_layouts(masonry.geometry))
        cells.push_back(count(layout_seed(masonry, static_cast<std::uint32_t>(sample))));
    const std::vector<double> values = flattened(draw(plan, level, sample));
    const std::vector<std::string_view> units = units_of(plan);
    for (std::size_t k = 0; k < values.size(); ++k)
        cells.emplace_back(Number{from_si(values[k], units[k])});
    return cells;
}

} // namespace

int sample_command(const Command& command)
{
    const StudySource source = study_source(command.study, command.overrides);
    const Study& study = source.ready.study;
    if (!is_random(study.geometry, study.random))
        throw error_at(study.source, "joint.friction_angle",
                       "nothing to draw: no value of this study is a distribution; write e.g. "
                       "\"friction_angle = normal(mean 31.8 deg, cov 0.20)\"");
    std::cerr << study_notes(source.ready, command.verb);
    if (const std::string note =
            check_replaced(command.out, "level,vertical_stress [MPa],sample");
        !command.quiet)
        std::cerr << note;
    const SamplePlan plan =
        sample_plan(study, study.load, study.source, source.ready.layout, source.sizes);
    Table table = head_of(study.geometry, plan);
    for (std::size_t level = 0; level < study.load.vertical_stress.size(); ++level)
        for (std::uint32_t sample = 0; sample < source.sizes.back(); ++sample)
            table.rows.push_back(row(study, study.load, plan, static_cast<int>(level),
                                     static_cast<int>(sample)));
    const std::filesystem::path file = command.out;
    if (file.has_parent_path()) make_folder(file.parent_path());
    write_file(file, as_csv(table));
    std::cout << table.rows.size() << (table.rows.size() == 1 ? " sample" : " samples")
              << " written to " << command.out << '\n';
    return 0;
}

} // namespace app
