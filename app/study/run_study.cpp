#include "app/study/run_study.hpp"

#include "app/input/random_layouts.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/output/atomic_output.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/provenance.hpp"
#include "app/study/study_file_head.hpp"
#include "app/study/study_stopping.hpp"
#include "app/study/study_walls.hpp"
#include "dem/scene/layout.hpp"

#include <cstdint>
#include <vector>

namespace app {
namespace {

/// @return whether it ran to the end
bool run_pending(const Study& study, const StudyRun& run, const SamplePlan& plan, Store& store)
{
    const std::vector<WallKey> walls =
        pending_walls(store, run.shard, run.rerun_failed, deal_of(study));
    try {
        if (run.seen) run.seen({.all = walls.size()});
        run_walls(study, plan, walls, run.threads, store, run.seen, run.frames);
    } catch (const Interrupted&) {
        return false;
    }
    return true;
}

/// Brings the file to the last of `sizes`. @return whether it ran to the end
bool work_on(const Study& study, const StudyRun& run, const std::vector<std::uint32_t>& sizes)
{
    const SamplePlan plan = sample_plan(study, layout_of(study), sizes);
    StoreHead head = head_of(study, plan, sizes);
    head.shard = static_cast<std::uint32_t>(run.shard.index);
    head.shards = static_cast<std::uint32_t>(run.shard.count);
    head.sessions = {this_session(run.threads)};
    Store store(run.file, head);
    const bool whole = run_pending(study, run, plan, store);
    store.compact();
    return whole;
}

void write_tables(const std::filesystem::path& file, const Table& table)
{
    const std::filesystem::path stem = file.parent_path() / (file.stem().string() + "_summary");
    write_file(stem.string() + ".csv", as_csv(table));
    write_file(stem.string() + ".md", as_markdown(table));
    write_file(stem.string() + ".tex", as_latex(table));
}

} // namespace

StudyRunEnd run_study(const Study& study, const StudyRun& run)
{
    if (run.file.has_parent_path()) make_folder(run.file.parent_path());
    std::vector<std::uint32_t> sizes = design_sizes(study, run.file);
    StudyRunEnd end{work_on(study, run, sizes), {}};
    if (study.uq.stop == kNoStop || !is_random(study)) return end;
    while (end.whole) {
        const StoppingState state =
            stopping_state(read_study_walls(run.file, {}, Keep::readings));
        end.remark = state.remark;
        if (state.next <= sizes.back()) break;
        sizes.push_back(state.next);
        end.whole = work_on(study, run, sizes);
    }
    return end;
}

StudySummary study_summary(const std::filesystem::path& file, bool write)
{
    StudySummary summary = summarise(read_study_walls(file, {}, Keep::readings));
    if (write) write_tables(file, summary.table);
    return summary;
}

} // namespace app
