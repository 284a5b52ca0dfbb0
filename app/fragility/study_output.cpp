#include "app/fragility/study_output.hpp"

#include "app/fragility/fragility_curves.hpp"
#include "app/fragility/fragility_cycles.hpp"
#include "app/fragility/fragility_inputs.hpp"
#include "app/fragility/fragility_means.hpp"
#include "app/fragility/fragility_modes.hpp"
#include "app/fragility/fragility_walls.hpp"
#include "app/fragility/numbers/answer_table.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/measured_drifts.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/fragility/numbers/sampling_errors.hpp"
#include "app/fragility/solver_error_table.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/part_tables.hpp"
#include "app/study/answers/pier_shares.hpp"
#include "app/study/study_summary.hpp"

#include <algorithm>
#include <iterator>

namespace app {
namespace {

void add_pictures(FragilityOutput& output, std::vector<NamedPicture> pictures)
{
    std::ranges::move(pictures, std::back_inserter(output.pictures));
}

/// Where fragility.ultimate_share was set anew: how walls of a finite push moved was stored at
/// that of the study.
std::string stored_share_text(const StudyWalls& walls)
{
    if (walls.head.configuration.empty()) return {}; // no file was read
    const Study stored = read_study(parse_study_text(walls.name, walls.head.configuration));
    const double drop = push_plan(stored).drop;
    if (drop == push_plan(walls.study).drop) return {};
    return "Modes, and the drift limits of codes that follow from them, are those where the "
           "force "
           "came down to " +
           percent_text(drop) +
           " of the peak, as the study was run. To read them elsewhere, run it with the other "
           "fragility.ultimate_share.\n";
}

/// "2 walls failed at 0.75 MPa: the energy ledger ..."
std::string remarks_of(const StudyWalls& walls)
{
    std::string text = limit_choices_text(limit_choices(walls.study)) + "\n";
    if (walls.shard)
        text += walls.name + ": drystone merge puts the shards of a study together.\n";
    text += stored_share_text(walls);
    if (!walls.pushed_one_way)
        text += backbone_text(walls.study.load, walls.study.fragility).substr(1) + "\n";
    const auto layouts = static_cast<std::uint32_t>(walls.study.geometry.layouts);
    const bool repeated = walls.levels.size() > 1 || walls.head.design_sizes.back() > layouts;
    if (has_layouts(walls.study.geometry) && repeated)
        text += "The samples lie in " + std::to_string(layouts) +
                " random layouts, the same under all stresses. Walls of one layout depend on "
                "each other; intervals treat them as independent and are too narrow where "
                "there are few layouts.\n";
    if (walls.shared)
        text +=
            "All stresses share one design: walls of two stresses depend on each other, and "
            "errors of the model over all stresses are too small.\n";
    return text;
}

/// @param data with its limit drifts chosen
FragilityOutput chosen_output(const DriftData& data)
{
    FragilityOutput output;
    output.source = counts_text(data);
    Table limits = performance_table(data);
    auto main = severest_rows(data, limits);
    output.tables = {{"performance_limits", std::move(limits), true, main},
                     {"law_parameters", law_table(data)},
                     {"goodness_of_fit", fit_table(data)}};
    if (!data.model_text.empty())
        output.tables.insert(
            output.tables.begin() + 1,
            {"limits_with_doubt", drift_doubt_table(data), true, std::move(main)});
    if (Table model = stress_table(data); !model.rows.empty())
        output.tables.push_back({"stress_model", std::move(model)});
    for (NamedTable& t : curve_tables(data)) output.tables.push_back(std::move(t));
    add_pictures(output, curve_pictures(data));
    output.pelicun = pelicun_csv(data);
    make_names_unique(output);
    return output;
}

} // namespace

FragilityOutput drift_output(DriftData data, const FitProgress& seen)
{
    choose_limits(data, seen);
    return chosen_output(data);
}

FragilityOutput study_output(const StudyWalls& walls, const FitProgress& seen)
{
    DriftData data = drift_data(walls);
    choose_limits(data, seen);
    FragilityOutput output = chosen_output(data);
    output.remarks = study_remarks(walls);
    output.told_by_study = output.remarks.size();
    output.remarks += remarks_of(walls);
    std::vector<NamedTable> tables = {{"modes", mode_table(walls), true, {}, true},
                                      {"forces_with_doubt", force_doubt_table(walls)},
                                      {"means_by_mode", mean_table(walls)},
                                      {"equal_modes", equal_modes_table(walls)},
                                      {"mode_thresholds", threshold_table(walls)},
                                      {"mean_curves", mean_curve_table(walls)},
                                      {"solver_error", solver_error_table(walls)},
                                      {"sampling_errors", sampling_error_table(walls)},
                                      {"walls", wall_table(walls, all_walls(walls))}};
    if (!walls.piers.empty()) {
        tables.insert(tables.begin(), {{"pier_limits", pier_share_table(walls), true},
                                       {"piers", study_pier_table(walls), true}});
        if (!walls.spandrels.empty())
            tables.insert(tables.begin() + 2, {"spandrels", study_spandrel_table(walls)});
    }
    if (!walls.inputs.empty()) tables.push_back({"inputs", input_table(walls)});
    if (!walls.pushed_one_way) tables.push_back({"cycles", cycle_table(walls)});
    tables.push_back({"measured_drifts", measured_drifts()});
    output.tables.insert(output.tables.begin() + 2, tables.begin(), tables.end());
    output.tables.insert(output.tables.begin(), {"answer", answer_table(walls, data), true});
    add_pictures(output, mean_curve_pictures(walls));
    add_pictures(output, cycle_pictures(walls));
    add_pictures(output, input_pictures(walls));
    make_names_unique(output);
    return output;
}

} // namespace app
