#include "app/shake/shake_study.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/replaced_file.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/history_summary.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/provenance.hpp"
#include "app/study/row_buffer.hpp"
#include "app/study/shard_file.hpp"
#include "app/study/study_file_head.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/thread_time.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace app {
namespace {

namespace fs = std::filesystem;

/// State shared by the threads of one call. The first exception ends them all, each at its next
/// look.
class HistoryRun {
  public:
    using Done = std::function<void(WallKey, const WallDraw&, ShakenHistory&&)>;

    HistoryRun(const PreparedStudy& ready, const HistoryPlan& plan, const SamplePlan& samples,
               const std::vector<WallKey>& histories, const Done& done)
        : study_(ready.study), plan_(plan), samples_(samples), histories_(histories),
          done_(done), moving_(moving_study(ready.study)),
          model_(model_of({moving_, ready.layout}))
    {
    }

    void run(int threads)
    {
        std::vector<std::thread> workers;
        for (int k = 1; k < threads; ++k) workers.emplace_back([this] { work(); });
        work();
        for (std::thread& w : workers) w.join();
        if (fault_) std::rethrow_exception(fault_);
    }

  private:
    struct Left {}; ///< another thread has met a fault

    void work()
    {
        try {
            for (std::size_t i = next_++; i < histories_.size(); i = next_++) {
                const WallKey key = histories_[i];
                const HistoryOf of = history_of(plan_, key.sample);
                const WallDraw drawn =
                    draw(samples_, static_cast<int>(key.level), static_cast<int>(of.wall));
                ShakenHistory h = shaken(key, of, drawn);
                const std::lock_guard lock(mutex_);
                if (ended_) return;
                done_(key, drawn, std::move(h));
            }
        } catch (const Left&) {
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!fault_) fault_ = std::current_exception();
            ended_ = true;
        }
    }

    void look() const
    {
        end_if_interrupted();
        if (ended_) throw Left();
    }

    ShakenHistory shaken(WallKey key, const HistoryOf& of, const WallDraw& drawn) const
    {
        look();
        const double begin = dem::thread_seconds();
        ShakenHistory h{
            of, shaking_motion(plan_.records, of.record, of.intensity), {}, {}, 0.0};
        dem::ShakePlan plan = shake_plan(study_, h.motion);
        plan.record_every = kNoHistory;
        plan.progress = [this](double, double) { look(); };
        dem::WallMaterials wall;
        try {
            wall = wall_materials(moving_, model_.layout, static_cast<int>(key.level), drawn);
            dem::check(model_, wall);
        } catch (const std::invalid_argument& bad) {
            h.no_wall = bad.what();
            return h;
        }
        h.result = dem::shake(model_, wall, plan, moving_.solver);
        h.seconds = dem::thread_seconds() - begin;
        return h;
    }

    static constexpr double kNoHistory = 1e9; // [s] between points that are not kept

    const Study& study_;
    const HistoryPlan& plan_;
    const SamplePlan& samples_;
    const std::vector<WallKey>& histories_;
    const Done& done_;
    const Study moving_;
    const dem::Model model_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> ended_{false};
    std::mutex mutex_;
    std::exception_ptr fault_;
};

std::string history_progress(const RunProgress& p)
{
    std::string text = std::to_string(p.before + p.done) + " of " +
                       std::to_string(p.before + p.all) + " histories";
    if (p.before > 0)
        text +=
            " (" + std::to_string(p.before) + " before, " + std::to_string(p.done) + " now)";
    return text + ", " + std::to_string(p.failed) + " failed";
}

/// Shakes what the store does not have. Finished histories are stored whatever happens then.
/// @param last set to how far it came
void shake_pending(const PreparedStudy& ready, const HistoryPlan& plan,
                   const SamplePlan& samples, const Command& command, Store& store,
                   RunProgress& last)
{
    const std::vector<WallKey> histories =
        pending_walls(store, command.shard, command.rerun_failed);
    last.all = histories.size();
    last.before = walls_of(store.head(), command.shard).size() - histories.size();
    RowBuffer rows(store);
    const double all = std::max(1.0, static_cast<double>(last.before + last.all));
    Progress line(std::cerr, stderr_progress(command.quiet), steady_seconds,
                  static_cast<double>(last.before) / all);
    try {
        run_histories(ready, plan, samples, histories, command.threads,
                      [&](WallKey key, const WallDraw& drawn, ShakenHistory&& h) {
                          last.failed += failed(h) ? 1 : 0;
                          ++last.done;
                          rows.add(history_row(key, drawn, plan, h));
                          line.update(static_cast<double>(last.before + last.done) / all,
                                      history_progress(last));
                      });
    } catch (...) {
        rows.flush();
        throw;
    }
    rows.flush();
    line.finish(history_progress(last));
}

/// Sizes through which the design of walls has grown.
std::vector<std::uint32_t> wall_sizes(const Study& study, const HistoryPlan& plan,
                                      const fs::path& file)
{
    const std::uint32_t samples = samples_of(study);
    std::vector<std::uint32_t> sizes;
    if (fs::exists(file)) sizes = read_head(file).design_sizes;
    for (std::uint32_t& size : sizes)
        size /= static_cast<std::uint32_t>(histories_per_wall(plan));
    if (sizes.empty() || samples > sizes.back()) sizes.push_back(samples);
    if (samples < sizes.back()) sizes = {samples}; // fewer than there are: refused later
    return sizes;
}

fs::path summary_file(const fs::path& file)
{
    return file.parent_path() / (file.stem().string() + "_summary.csv");
}

void check_size(const Study& study, const HistoryPlan& plan)
{
    const double all = static_cast<double>(histories_per_wall(plan)) * samples_of(study);
    if (all * static_cast<double>(study.load.vertical_stress.size()) >
        static_cast<double>(kMostWalls))
        throw error_at(study.source, "shaking.records",
                       "make more than a hundred million histories; take fewer records, "
                       "intensities or samples");
}

} // namespace

bool is_shaken(const StudyFile& file) { return is_given(file, "shaking.records"); }

void run_histories(const PreparedStudy& ready, const HistoryPlan& plan,
                   const SamplePlan& samples, const std::vector<WallKey>& histories,
                   int threads,
                   const std::function<void(WallKey, const WallDraw&, ShakenHistory&&)>& done)
{
    if (histories.empty()) return;
    const auto most = static_cast<int>(std::min<std::size_t>(histories.size(), 1024));
    HistoryRun(ready, plan, samples, histories, done).run(std::clamp(threads, 1, most));
}

int shake_study_command(const Command& command)
{
    PreparedStudy ready = prepare(read_study(command.study, command.overrides));
    Study& study = ready.study;
    const HistoryPlan plan = history_plan(study);
    check_size(study, plan);
    study.solver.kinematics = dem::Kinematics::finite; // whatever the default of a push
    std::cerr << study_notes(ready, command.verb);
    if (!command.script.empty())
        throw ConfigError("drystone", 0, "--slurm",
                          "writes no job array of a study that shakes walls yet; give each "
                          "job its --shard I/N");
    const fs::path file = shard_file(command.out, command.shard);
    const bool whole_study = command.shard.count == 1;
    if (whole_study)
        if (const std::string note = check_replaced(summary_file(file), kHistorySummaryHead);
            !command.quiet)
            std::cerr << note;
    if (file.has_parent_path()) make_folder(file.parent_path());
    if (fs::exists(file)) refuse_changed_records(study, plan, file);
    catch_interrupts();
    const std::vector<std::uint32_t> sizes = wall_sizes(study, plan, file);
    const SamplePlan samples = sample_plan(study, ready.layout, sizes);
    StoreHead head = history_head(study, plan, samples, sizes);
    head.shard = static_cast<std::uint32_t>(command.shard.index);
    head.shards = static_cast<std::uint32_t>(command.shard.count);
    head.sessions = {this_session(command.threads)};
    RunProgress last;
    bool whole = true;
    {
        Store store(file, head);
        try {
            shake_pending(ready, plan, samples, command, store, last);
        } catch (const Interrupted&) {
            whole = false;
        } catch (const std::invalid_argument& bad) {
            throw ConfigError(command.study, 0, "", bad.what());
        }
        store.compact();
    }
    const HistorySummary summary = history_summary(read_histories(file));
    if (whole_study) write_file(summary_file(file), as_csv(summary.table));
    std::cout << as_text(summary.table, terminal_width())
              << wrapped(summary.remarks, terminal_width())
              << "verified against closed forms, not validated\nwritten to " << file.string()
              << '\n';
    if (!whole) throw Interrupted{"the same command resumes where it stopped"};
    return summary.failed == 0 ? 0 : 1;
}

} // namespace app
