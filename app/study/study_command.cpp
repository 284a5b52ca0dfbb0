#include "app/study/study_command.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/number_text.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/markup.hpp"
#include "app/output/progress.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/provenance.hpp"
#include "app/study/slurm_command.hpp"
#include "app/study/study_file_head.hpp"
#include "app/study/study_runner.hpp"
#include "app/study/study_stopping.hpp"
#include "app/study/study_summary.hpp"
#include "app/study/study_walls.hpp"
#include "dem/block/model.hpp"

#include <filesystem>
#include <iostream>

namespace app {
namespace {

namespace fs = std::filesystem;

/// "runs/paper.h5", shard 3 of 16: "runs/paper_03_of_16.h5"
fs::path shard_file(const fs::path& out, Shard shard)
{
    if (shard.count == 1) return out;
    std::string index = std::to_string(shard.index + 1);
    const std::string count = std::to_string(shard.count);
    index.insert(0, count.size() - index.size(), '0');
    fs::path file = out;
    file.replace_filename(out.stem().string() + "_" + index + "_of_" + count +
                          out.extension().string());
    return file;
}

std::string progress_text(const RunProgress& p, double seconds)
{
    return std::to_string(p.done) + " of " + std::to_string(p.all) + " walls, " +
           std::to_string(p.failed) + " failed, " +
           fixed(static_cast<double>(p.done) / std::max(seconds, 1e-9), 1) + " walls/s";
}

/// One process at work on a study.
struct Work {
    const Study& study;
    const Command& command;
    fs::path file;
    dem::Model model;
    FrameTaker frames;
};

/// @return whether it ran to the end
bool run(const Work& w, const SamplePlan& plan, Store& store)
{
    const std::vector<WallKey> walls =
        pending_walls(store, w.command.shard, w.command.rerun_failed);
    Progress progress(std::cerr, stderr_progress(w.command.quiet), steady_seconds);
    const double start = steady_seconds();
    RunProgress last;
    try {
        last = run_walls(
            w.study, w.model, plan, walls, w.command.threads, store,
            [&](const RunProgress& p) {
                progress.update(static_cast<double>(p.done) / static_cast<double>(p.all),
                                progress_text(p, steady_seconds() - start));
            },
            w.frames);
    } catch (const Interrupted&) {
        return false;
    }
    progress.finish(progress_text(last, steady_seconds() - start));
    return true;
}

/// Brings the file to the last of `sizes`. @return whether it ran to the end
bool work_on(const Work& w, const std::vector<std::uint32_t>& sizes)
{
    const SamplePlan plan = sample_plan(w.study, w.model.layout, sizes);
    StoreHead head = head_of(w.study, plan, sizes);
    head.shard = static_cast<std::uint32_t>(w.command.shard.index);
    head.shards = static_cast<std::uint32_t>(w.command.shard.count);
    head.sessions = {this_session(w.command.threads)};
    Store store(w.file, head);
    const bool whole = run(w, plan, store);
    store.compact();
    return whole;
}

/// Adds samples until the rule of the study is content, if it has one.
bool work_until_enough(const Work& w, std::string& remark)
{
    std::vector<std::uint32_t> sizes = design_sizes(w.study, w.file);
    bool whole = work_on(w, sizes);
    if (w.study.uq.stop == kNoStop || w.study.random.empty()) return whole;
    while (whole) {
        const StoppingState state =
            stopping_state(read_study_walls(w.file, {}, Keep::readings));
        remark = state.remark;
        if (state.next <= sizes.back()) break;
        sizes.push_back(state.next);
        whole = work_on(w, sizes);
    }
    return whole;
}

void check_stop(const Study& study, const Command& command)
{
    const bool shards = command.shard.count > 1 || !command.script.empty();
    if (study.uq.stop != kNoStop && shards)
        throw error_at(study.source, "uq.stop",
                       "a shard cannot tell when the study is enough; give uq.samples");
}

void write_summary(const fs::path& file, const Table& table)
{
    const fs::path stem = file.parent_path() / (file.stem().string() + "_summary");
    write_file(stem.string() + ".csv", as_csv(table));
    write_file(stem.string() + ".md", as_markdown(table));
    write_file(stem.string() + ".tex", as_latex(table));
}

} // namespace

int study_command(const Command& command, const FrameTaker& frames)
{
    const Study study =
        read_study(with_overrides(read_study_file(command.study), command.overrides));
    check_stop(study, command);
    say_effects(study, command);
    if (!command.script.empty()) return write_slurm_script(study, command);
    const Work work{study, command, shard_file(command.out, command.shard), model_of(study),
                    frames};
    if (work.file.has_parent_path()) make_folder(work.file.parent_path());
    catch_interrupts();
    std::string remark;
    const bool whole = work_until_enough(work, remark);
    const StudySummary summary = summarise(read_study_walls(work.file, {}, Keep::readings));
    if (command.shard.count == 1) write_summary(work.file, summary.table);
    std::cout << as_text(summary.table, terminal_width()) << summary.remarks << remark
              << "written to " << work.file.string() << '\n';
    if (!whole)
        std::cerr << "drystone: interrupted; the same command goes on where it stopped\n";
    return whole && summary.failed == 0 ? 0 : 1;
}

} // namespace app
