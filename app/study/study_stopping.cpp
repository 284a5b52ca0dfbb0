#include "app/study/study_stopping.hpp"

#include "app/input/number_text.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/study_columns.hpp"
#include "dem/scene/mechanism.hpp"
#include "uq/estimates/stopping.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace app {
namespace {

constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();

uq::StoppingRule rule_of(const UqInput& uq)
{
    uq::StoppingRule rule;
    const bool share = uq.stop == StopQuantity::mixed_share;
    rule.target = share ? uq::StoppingTarget::probability_below : uq::StoppingTarget::mean;
    rule.threshold = 0.5; // of 0: mixed, 1: rocking
    rule.relative = !share;
    rule.half_width = uq.stop_half_width;
    rule.min_n = std::max<std::size_t>(2, static_cast<std::size_t>(uq.samples));
    rule.max_n = std::max(rule.min_n, static_cast<std::size_t>(uq.most_samples));
    return rule;
}

/// The value of a wall that the rule looks at. An ultimate displacement that is only a bound counts with
/// its bound, as in the mean of the paper's tables.
double value_of(const WallRow& row, StopQuantity quantity, const StoreHead& head)
{
    if (row.status != kWallOk) return kFailed;
    if (quantity == StopQuantity::mixed_share)
        return row.counts[column_of(head.counts, "mode")] ==
                       static_cast<std::int64_t>(dem::FailureMode::mixed)
                   ? 0.0
                   : 1.0;
    return row.responses[column_of(head.responses, quantity == StopQuantity::peak_force
                                                       ? "peak_force"
                                                       : "ultimate_displacement")];
}

std::vector<std::vector<double>> values(const std::filesystem::path& file,
                                        StopQuantity quantity)
{
    StoreReader reader(file);
    const StoreHead head = reader.head();
    std::vector<std::vector<double>> all(head.levels.size());
    reader.for_each_row([&](const WallRow& row) {
        all[row.key.level].push_back(value_of(row, quantity, head));
    });
    return all;
}

} // namespace

StoppingState stopping_state(const Study& study, const std::filesystem::path& file)
{
    const uq::StoppingRule rule = rule_of(study.uq);
    StoppingState state;
    const auto levels = values(file, study.uq.stop);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const uq::StoppingDecision d = uq::judge(rule, levels[i]);
        state.next = std::max(state.next, static_cast<std::uint32_t>(d.next_n));
        state.remark += number(study.load.vertical_stress[i] * 1e-6, 12) +
                        " MPa: " + std::to_string(levels[i].size()) + " walls, half width " +
                        number(d.half_width, 3) + " of " + number(rule.half_width, 3) + ", " +
                        std::string(words(d.reason)) + "\n";
    }
    return state;
}

} // namespace app
