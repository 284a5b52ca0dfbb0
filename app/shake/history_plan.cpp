#include "app/shake/history_plan.hpp"

#include "app/input/study_reading.hpp"
#include "app/shake/history_row.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/text/check_sum.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <string_view>

namespace app {
namespace {

/// Periods of the spectral accelerations that are kept, and of what is taken over a range of
/// periods [s]: choice.
constexpr std::array kPeriods = {0.1, 0.2, 0.3, 0.5, 1.0, 2.0};
constexpr std::array kWidePeriods = {0.3, 0.5, 1.0};

/// @param block the wall as one block
std::vector<ground::Measure> kept_measures(const ground::Measure& own,
                                           const ground::RockingBlock& block)
{
    using enum ground::MeasureKind;
    std::vector<ground::Measure> all = {{pga}, {pgv}, {pgd}, {arias}, {cav}, {duration}};
    for (const double period : kPeriods) all.push_back({.kind = sa, .period = period});
    for (const auto kind : {avg_sa, fiv3})
        for (const double period : kWidePeriods)
            all.push_back({.kind = kind, .period = period});
    for (const auto kind : {rocking_pga, rocking_pgv})
        all.push_back({.kind = kind, .block = block});
    if (std::ranges::count(all, own) == 0) all.push_back(own);
    return all;
}

/// Bytes of numbers, for a check sum.
std::string_view bytes_of(const std::vector<double>& x)
{
    return {reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)}; // NOLINT
}

std::string sum_of(const ShakingRecord& r)
{
    std::string all(bytes_of(r.horizontal.acceleration));
    all += bytes_of({r.horizontal.step});
    if (r.vertical) all += bytes_of(r.vertical->acceleration);
    return check_sum(all);
}

/// A name on one line without the mark that ends it.
std::string name_in_line(const std::string& name)
{
    std::string safe = name;
    std::ranges::replace_if(
        safe, [](char c) { return c == '\n' || c == ';' || c == '\0'; }, ' ');
    return safe;
}

} // namespace

HistoryPlan history_plan(const PreparedStudy& ready)
{
    const Study& study = ready.study;
    check_shaken_study(study, study.solver, study.shaking, study.source);
    if (study.uq.stop != kNoStop)
        throw error_at(study.source, "uq.stop",
                       "a study of walls that are shaken has no such rule; remove it, and give "
                       "uq.samples");
    if (study.uq.audit > 0)
        throw error_at(study.source, "uq.audit",
                       "pushes walls again more slowly, and these are shaken; remove it");
    HistoryPlan plan;
    plan.records = shaking_records(study.shaking, study.source);
    plan.design = study.shaking.design;
    plan.measures = kept_measures(plan.records.at.measure,
                                  {0.5 * ready.layout.length, 0.5 * ready.layout.height});
    return plan;
}

std::size_t histories_per_wall(const HistoryPlan& plan)
{
    const bool crossed = plan.design == ShakingDesign::crossed;
    return intensity_count(plan.records) * (crossed ? plan.records.records.size() : 1);
}

HistoryOf history_of(const HistoryPlan& plan, std::uint32_t sample)
{
    const std::size_t intensities = intensity_count(plan.records),
                      records = plan.records.records.size();
    HistoryOf h;
    h.intensity = sample % intensities;
    h.wall = sample / histories_per_wall(plan);
    h.record = plan.design == ShakingDesign::crossed ? sample / intensities % records
                                                     : h.wall % records;
    return h;
}

std::vector<std::string> record_lines_of(const ShakingRecords& records)
{
    std::vector<std::string> lines;
    for (const ShakingRecord& r : records.records)
        lines.push_back(std::string(kRecordLine) + std::to_string(lines.size() + 1) + " = " +
                        name_in_line(r.horizontal.name) + "; sum " + sum_of(r));
    return lines;
}

std::vector<std::uint32_t> stored_walls(const StoreHead& head, const HistoryPlan& plan)
{
    std::vector<std::uint32_t> sizes = head.design_sizes;
    for (std::uint32_t& size : sizes)
        size /= static_cast<std::uint32_t>(histories_per_wall(plan));
    return sizes;
}

StoreHead history_head(const Study& study, const HistoryPlan& plan, const SamplePlan& samples,
                       std::vector<std::uint32_t> walls)
{
    const auto each = static_cast<std::uint32_t>(histories_per_wall(plan));
    StoreHead head;
    head.configuration = effective_configuration(study);
    head.identity = identity_text(study);
    for (const std::string& line : record_lines_of(plan.records)) head.identity += line + "\n";
    for (std::uint32_t& size : walls) size *= each;
    for (const double stress : study.load.vertical_stress)
        head.levels.push_back({stress, walls.back()});
    head.design_sizes = std::move(walls);
    head.seed = study.uq.seed;
    head.inputs = input_columns(samples);
    head.responses = history_responses(plan);
    head.counts = history_counts();
    head.cost = cost_columns();
    return head;
}

void refuse_changed_records(const StudyFile& source, const HistoryPlan& plan,
                            const std::filesystem::path& file)
{
    const StoreHead stored = read_head(file);
    if (!holds_histories(stored))
        throw error_at(source, "shaking.records",
                       "this study shakes walls, and " + in_quotes(file.string()) +
                           " holds pushes; name another file with --out");
    const std::vector<std::string> before = record_lines(stored.identity),
                                   now = record_lines_of(plan.records);
    for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
        if (before[i] == now[i]) continue;
        const std::string was = record_name(before[i]), is = record_name(now[i]);
        throw error_at(
            source, "shaking.records",
            was == is ? in_quotes(is) + " has changed since " + in_quotes(file.string()) +
                            " was begun; put the record back as it was, or name another "
                            "file with --out"
                      : "record " + std::to_string(i + 1) + " is " + in_quotes(is) + ", and " +
                            in_quotes(was) + " in " + in_quotes(file.string()) +
                            "; put the records back as they were, or name another file with "
                            "--out");
    }
    if (before.size() != now.size())
        throw error_at(source, "shaking.records",
                       "names " + std::to_string(now.size()) + " records, and " +
                           in_quotes(file.string()) + " was begun with " +
                           std::to_string(before.size()) +
                           "; put the records back as they were, or name another file with "
                           "--out");
}

} // namespace app
