#include "app/study/study_command.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/run_study.hpp"
#include "app/study/shard_file.hpp"
#include "app/study/slurm_command.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace app {
namespace {

/// "16 of 120 walls"; of a study that goes on "120 of 120 walls (104 before, 16 now)"; of an
/// audit "4 of 8 walls of the audit", of the other direction "4 of 8 walls the other way"
std::string progress_text(const RunProgress& p, double seconds)
{
    std::string text = std::to_string(p.before + p.done) + " of " +
                       std::to_string(p.before + p.all) + " walls" +
                       (p.round == Round::audit    ? " of the audit"
                        : p.round == Round::turned ? " the other way"
                                                   : "");
    if (p.before > 0)
        text +=
            " (" + std::to_string(p.before) + " before, " + std::to_string(p.done) + " now)";
    return text + ", " + std::to_string(p.failed) + " failed, " +
           fixed(static_cast<double>(p.done) / std::max(seconds, 1e-9), 1) + " walls/s";
}

/// Text on what a study that went on has now; empty if it had no wall before.
std::string resumed_text(const StudyRunEnd& end)
{
    if (end.before == 0) return "";
    return std::to_string(end.before + end.now) +
           " walls in the file: " + std::to_string(end.before) + " from before, " +
           std::to_string(end.now) + " of this run\n";
}

/// Warns of a shard that cannot tell of every stress.
void say_levels(const Masonry& masonry, const LoadInput& load, const Sampling& sampling,
                Shard shard)
{
    StoreHead head;
    for (const double stress : load.vertical_stress)
        head.levels.push_back({stress, samples_of(masonry.geometry, sampling)});
    std::set<std::uint32_t> here;
    for (const WallKey wall : walls_of(head, shard, deal_of(masonry.geometry)))
        here.insert(wall.level);
    if (here.size() == head.levels.size()) return;
    std::cerr << wrapped(
        "note: this shard has walls under " + std::to_string(here.size()) + " of " +
            std::to_string(head.levels.size()) + " stresses because there are fewer samples (" +
            std::to_string(samples_of(masonry.geometry, sampling)) + ") than shards (" +
            std::to_string(shard.count) + "); alone it says nothing about the others\n",
        terminal_width());
}

/// Shows how far a study is: a line for each round of walls.
class RunLine {
  public:
    explicit RunLine(bool quiet) : quiet_(quiet) {}
    void see(const RunProgress& p)
    {
        if (p.done == 0) {
            start_ = steady_seconds();
            const double all = static_cast<double>(p.before + p.all);
            line_.emplace(std::cerr, stderr_progress(quiet_), steady_seconds,
                          static_cast<double>(p.before) / std::max(all, 1.0));
        }
        const std::string text = progress_text(p, steady_seconds() - start_);
        if (p.done < p.all)
            line_->update(static_cast<double>(p.before + p.done) /
                              static_cast<double>(p.before + p.all),
                          text);
        else
            line_->finish(text);
    }

  private:
    bool quiet_;
    double start_ = 0.0; ///< of the round [s]
    std::optional<Progress> line_;
};

/// Pushes the walls, with a line on stderr meanwhile.
StudyRunEnd run_with_line(const PreparedStudy& ready, StudyRun run, bool quiet)
{
    RunLine line(quiet);
    run.seen = [&](const RunProgress& p) { line.see(p); };
    return run_study(ready, run);
}

void check_stop(const UqInput& uq, const StudyFile& source, const Command& command)
{
    const bool shards = command.shard.count > 1 || !command.script.empty();
    if (uq.stop != kNoStop && shards)
        throw error_at(source, "uq.stop",
                       "a shard cannot tell when the study has enough walls; give uq.samples");
}

} // namespace

int study_command(const Command& command, const FrameTaker& frames)
{
    const PreparedStudy ready = prepare(read_study(command.study, command.overrides));
    const Study& study = ready.study;
    check_stop(study.uq, study.source, command);
    std::cerr << study_notes(ready, command.verb);
    if (!command.script.empty()) return write_slurm_script(pushing_work(ready), command);
    StudyRun run;
    run.file = shard_file(command.out, command.shard);
    run.shard = command.shard;
    run.threads = command.threads;
    run.rerun_failed = command.rerun_failed;
    run.frames = frames;
    if (command.shard.count == 1) check_summary(run.file);
    if (!command.quiet) say_levels(study, study.load, study, run.shard);
    catch_interrupts();
    const StudyRunEnd end = run_with_line(ready, run, command.quiet);
    const StudySummary summary = study_summary(run.file, command.shard.count == 1);
    std::cout << as_text(summary.table, terminal_width())
              << wrapped(summary.remarks, terminal_width()) << end.remark << resumed_text(end)
              << "written to " << run.file.string() << '\n';
    if (!end.whole) throw Interrupted{"the same command resumes where it stopped"};
    return summary.failed == 0 ? 0 : 1;
}

} // namespace app
