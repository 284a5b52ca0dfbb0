#include "app/study/run_study.hpp"

#include "app/input/wall/random_layouts.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/replaced_file.hpp"
#include "app/output/table/table_files.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/provenance.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/study_stopping.hpp"

#include <cstdint>
#include <tuple>
#include <vector>

namespace app {
namespace {

/// The study as the walls of a round are pushed.
PreparedStudy study_of(const PreparedStudy& ready, Round round)
{
    switch (round) {
    case Round::turned:
        return lay_again(turned_round(ready.study));
    case Round::audit:
        return audit_study(ready);
    default:
        return ready;
    }
}

/// Pushes the walls of a round that the store does not have.
/// @param last what to push, and set to how far it came
void run_pending(const PreparedStudy& ready, const StudyRun& run, const SamplePlan& plan,
                 Store& store, RunProgress& last)
{
    const Deal deal = deal_of(ready.study.geometry);
    const std::vector<WallKey> walls =
        pending_walls(store, run.shard, run.rerun_failed, deal, last.round);
    const std::size_t all = walls_of(store.head(), run.shard, deal, last.round).size();
    if (last.round != Round::own && all == 0) return;
    last.all = walls.size();
    last.before = all - walls.size();
    const auto seen = [&](const RunProgress& p) {
        last = p;
        if (run.seen) run.seen(p);
    };
    const RunProgress start = last;
    seen(start);
    run_walls(study_of(ready, last.round), plan, walls, run.threads, store, seen,
              last.round == Round::own ? run.frames : FrameTaker(), start);
}

/// A shard that was begun when walls were divided otherwise would continue with walls that
/// another shard has.
void refuse_other_deal(const GeometryInput& geometry, const StudyRun& run)
{
    std::error_code ignored;
    if (run.shard.count == 1 || !std::filesystem::exists(run.file, ignored)) return;
    StoreReader reader(run.file);
    const std::vector<WallKey> foreign =
        foreign_walls(reader.head(), reader.statuses(), deal_of(geometry));
    if (!foreign.empty())
        throw BadStoredStudy(
            "'" + run.file.string() + "' has " + wall_name(foreign.front()) +
            ", which is not of this shard: the file was begun by a version of the "
            "program that divides the walls otherwise. Continue all shards with "
            "that version, or name another file; shards that are finished can be "
            "merged.");
}

/// Brings the file to the last of `sizes`.
/// @param end takes whether it ran to the end, and the walls of this round
void work_on(const PreparedStudy& ready, const StudyRun& run,
             const std::vector<std::uint32_t>& sizes, StudyRunEnd& end)
{
    const Study& study = ready.study;
    refuse_other_deal(study.geometry, run);
    const SamplePlan plan = sample_plan(study, study.load, study.source, ready.layout, sizes);
    StoreHead head = head_of(study, ready.layout, plan, sizes);
    head.shard = static_cast<std::uint32_t>(run.shard.index);
    head.shards = static_cast<std::uint32_t>(run.shard.count);
    head.sessions = {this_session(run.threads)};
    Store store(run.file, head);
    RunProgress last, turned{.round = Round::turned}, audit{.round = Round::audit};
    try {
        run_pending(ready, run, plan, store, last);
        run_pending(ready, run, plan, store, turned);
        run_pending(ready, run, plan, store, audit);
        end.whole = true;
    } catch (const Interrupted&) {
        end.whole = false;
    }
    if (end.now == 0) end.before = last.before; // of the first round
    end.now += last.done;
    store.compact();
}

/// "runs/paper_summary"
std::string summary_stem(const std::filesystem::path& file)
{
    return (file.parent_path() / (file.stem().string() + "_summary")).string();
}

} // namespace

StudyRunEnd run_study(const PreparedStudy& ready, const StudyRun& run)
{
    const Study& study = ready.study;
    if (run.file.has_parent_path()) make_folder(run.file.parent_path());
    std::vector<std::uint32_t> sizes = design_sizes(study.geometry, study, run.file);
    StudyRunEnd end;
    work_on(ready, run, sizes, end);
    if (study.uq.stop == kNoStop || !is_random(study.geometry, study.random)) return end;
    while (end.whole) {
        const StoppingState state =
            stopping_state(read_study_walls(run.file, {}, Keep::readings));
        end.remark = state.remark;
        if (state.next <= sizes.back()) break;
        sizes.push_back(state.next);
        work_on(ready, run, sizes, end);
    }
    return end;
}

void check_summary(const std::filesystem::path& file)
{
    // No note: the file of a study is its own study's.
    std::ignore = check_replaced(summary_stem(file) + ".csv", "stress [MPa],walls,failed");
    for (const char* const ending : {".md", ".tex"})
        std::ignore = check_replaced(summary_stem(file) + ending, kSummaryTitle);
}

StudySummary study_summary(const std::filesystem::path& file, bool write)
{
    StudySummary summary = summarise(read_study_walls(file, {}, Keep::readings));
    if (!write) return summary;
    for (const OutputFile& f : table_files(summary_stem(file), summary.table))
        write_file(f.name, f.content);
    return summary;
}

} // namespace app
