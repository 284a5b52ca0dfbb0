#include "app/shake/shake_study.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/replaced_file.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/pushed_limits.hpp"
#include "app/study/pushed/row_buffer.hpp"
#include "app/study/shard_file.hpp"
#include "app/study/slurm_command.hpp"
#include "app/study/stored/history_summary.hpp"
#include "app/study/stored/provenance.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "dem/block/model.hpp"
#include "dem/shaking/shake_ensemble.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/solver_lanes.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double kNoHistory = 1e9; // [s] between points that are not kept

struct Begun {
    WallDraw draw;
    ShakenHistory history;
};

Begun begun_of(const HistoryPlan& plan, const SamplePlan& samples, const WallKey& key)
{
    const HistoryOf of = history_of(plan, key.sample);
    return {draw(samples, static_cast<int>(key.level), static_cast<int>(of.wall)),
            {of, shaking_motion(plan.records, of.record, of.intensity), {}, {}, 0.0}};
}

/// Shakes walls of one layout and hands out their rows.
class HistoryRuns {
  public:
    using Done = std::function<void(WallKey, const WallDraw&, ShakenHistory&&)>;

    HistoryRuns(const PreparedStudy& ready, const HistoryPlan& plan, const SamplePlan& samples,
                const std::vector<WallKey>& histories, const Done& done)
        : ready_(ready), plan_(plan), samples_(samples), histories_(histories), done_(done),
          moving_(moving_study(ready.study)), model_(model_of({moving_, ready.layout}))
    {
    }

    void run(int threads)
    {
        if (ready_.study.shaking.push)
            limits_ = pushed_limits(ready_, samples_, walls(), threads);
        dem::ShakenEnsemble all;
        all.size = histories_.size();
        all.damps = ready_.study.shaking.contact_damping > 0.0;
        all.history = [this](std::size_t i) { return begin(i); };
        all.done = [this](std::size_t i, dem::ShakeResult&& result) {
            end(i, std::move(result));
        };
        dem::Workers workers;
        workers.threads = threads;
        workers.scalar = all.size <= static_cast<std::size_t>(threads); // no register to fill
        dem::shake_ensemble(model_, all, moving_.solver, workers);
    }

  private:
    [[nodiscard]] WallKey wall_of(const WallKey& history) const
    {
        const HistoryOf of = history_of(plan_, history.sample);
        return {history.level, static_cast<std::uint32_t>(of.wall)};
    }

    /// Each wall under each stress once.
    [[nodiscard]] std::vector<WallKey> walls() const
    {
        std::vector<WallKey> all;
        for (const WallKey& h : histories_) all.push_back(wall_of(h));
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    std::optional<dem::HistoryInput> begin(std::size_t i)
    {
        end_if_interrupted();
        const WallKey key = histories_[i];
        Begun begun = begun_of(plan_, samples_, key);
        dem::HistoryInput in;
        try {
            in.materials =
                wall_materials(moving_, moving_.random,
                               stress_level(moving_.load, static_cast<int>(key.level)),
                               model_.layout, begun.draw);
            dem::check(model_, in.materials);
        } catch (const std::invalid_argument& bad) {
            begun.history.no_wall = bad.what();
            const std::lock_guard lock(mutex_);
            done_(key, begun.draw, std::move(begun.history));
            return {};
        }
        in.plan = shake_plan(ready_.study.load, ready_.study.shaking, begun.history.motion);
        in.plan.record_every = kNoHistory;
        in.plan.progress = [](double, double) { end_if_interrupted(); };
        const std::lock_guard lock(mutex_);
        begun_.emplace(i, std::move(begun));
        return in;
    }

    void end(std::size_t i, dem::ShakeResult&& result)
    {
        const std::lock_guard lock(mutex_);
        Begun begun = std::move(begun_.extract(i).mapped());
        begun.history.seconds = result.seconds;
        if (const auto at = limits_.find(wall_of(histories_[i])); at != limits_.end())
            begun.history.pushed_limit = at->second;
        begun.history.result = std::move(result);
        done_(histories_[i], begun.draw, std::move(begun.history));
    }

    const PreparedStudy& ready_;
    const HistoryPlan& plan_;
    const SamplePlan& samples_;
    const std::vector<WallKey>& histories_;
    const Done& done_;
    const Study moving_;
    const dem::Model model_;
    std::mutex mutex_; // of begun_ and of done_
    std::map<std::size_t, Begun> begun_;
    std::map<WallKey, double> limits_; ///< ultimate drifts of pushes [-]
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
std::vector<std::uint32_t> wall_sizes(const GeometryInput& geometry, const Sampling& sampling,
                                      const HistoryPlan& plan, const fs::path& file)
{
    const std::uint32_t samples = samples_of(geometry, sampling);
    std::vector<std::uint32_t> sizes;
    if (fs::exists(file)) sizes = stored_walls(read_head(file), plan);
    if (sizes.empty() || samples > sizes.back()) sizes.push_back(samples);
    if (samples < sizes.back()) sizes = {samples}; // fewer than there are: refused later
    return sizes;
}

fs::path summary_file(const fs::path& file)
{
    return file.parent_path() / (file.stem().string() + "_summary.csv");
}

/// Histories under long records come first, so that registers stay full to the end.
std::vector<WallKey> longest_first(const HistoryPlan& plan, std::vector<WallKey> histories)
{
    const auto duration = [&](const WallKey& key) {
        const ground::GroundMotion& m =
            plan.records.records.at(history_of(plan, key.sample).record).horizontal;
        return m.step * static_cast<double>(m.acceleration.size());
    };
    std::ranges::stable_sort(histories, std::greater{}, duration);
    return histories;
}

/// Runs one register of histories, from all over the study, to know what one takes; and, where
/// walls are pushed as well, one register of pushes.
StudyWork shaking_work(const PreparedStudy& ready, const HistoryPlan& plan)
{
    const std::vector<std::uint32_t> sizes = {samples_of(ready.study.geometry, ready.study)};
    const SamplePlan samples =
        sample_plan(ready.study, ready.study.load, ready.study.source, ready.layout, sizes);
    const std::size_t levels = ready.study.load.vertical_stress.size(),
                      each = sizes.front() * histories_per_wall(plan), all = levels * each;
    std::vector<WallKey> pilot;
    const std::size_t n = std::min<std::size_t>(dem::solver_lanes(), all);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = (2 * i + 1) * all / (2 * n);
        pilot.push_back(
            {static_cast<std::uint32_t>(at / each), static_cast<std::uint32_t>(at % each)});
    }
    double seconds = 0.0;
    PreparedStudy alone = ready;
    alone.study.shaking.push = false;
    run_histories(alone, plan, samples, pilot, 1,
                  [&](WallKey, const WallDraw&, ShakenHistory&& h) { seconds += h.seconds; });
    const double mean = seconds / static_cast<double>(n);
    StudyWork work{all, "histories", mean, mean * static_cast<double>(all), 0, 0.0};
    if (ready.study.shaking.push) {
        const StudyWork pushes = pushing_work(ready);
        work.pushed = pushes.runs;
        work.each_push = pushes.each;
    }
    return work;
}

void check_size(const Masonry& masonry, const Sampling& sampling, const LoadInput& load,
                const StudyFile& source, const HistoryPlan& plan)
{
    const double all =
        static_cast<double>(histories_per_wall(plan)) * samples_of(masonry.geometry, sampling);
    if (all * static_cast<double>(load.vertical_stress.size()) >
        static_cast<double>(kMostWalls))
        throw error_at(source, "shaking.records",
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
    const int used = std::clamp(threads, 1, most);
    const std::vector<WallKey> order = longest_first(plan, histories);
    const Study& study = ready.study;
    if (!has_layouts(study.geometry))
        return HistoryRuns(ready, plan, samples, order, done).run(used);
    std::map<std::uint32_t, std::vector<WallKey>> of_layout; // by its seed
    for (const WallKey& key : order) {
        const std::size_t wall = history_of(plan, key.sample).wall;
        of_layout[layout_seed(study, static_cast<std::uint32_t>(wall))].push_back(key);
    }
    for (const auto& layout : of_layout) {
        const std::vector<WallKey>& some = layout.second;
        std::optional<PreparedStudy> own;
        std::optional<HistoryRuns> runs;
        const auto refuse = [&](const std::exception& bad) {
            for (const WallKey& key : some) {
                Begun begun = begun_of(plan, samples, key);
                begun.history.no_wall = bad.what();
                done(key, begun.draw, std::move(begun.history));
            }
        };
        try {
            own = in_layout(study, layout.first);
            runs.emplace(*own, plan, samples, some, done);
        } catch (const ConfigError& bad) {
            refuse(bad);
        } catch (const std::invalid_argument& bad) {
            refuse(bad);
        }
        if (runs) runs->run(used);
    }
}

int shake_study_command(const Command& command)
{
    PreparedStudy ready = prepare(read_study(command.study, command.overrides));
    Study& study = ready.study;
    const HistoryPlan plan = history_plan(ready);
    check_size(study, study, study.load, study.source, plan);
    study.solver.kinematics = dem::Kinematics::finite; // whatever the default of a push
    std::cerr << study_notes(ready, command.verb);
    if (!command.script.empty()) return write_slurm_script(shaking_work(ready, plan), command);
    const fs::path file = shard_file(command.out, command.shard);
    const bool whole_study = command.shard.count == 1;
    if (whole_study)
        if (const std::string note = check_replaced(summary_file(file), kHistorySummaryMark);
            !command.quiet)
            std::cerr << note;
    if (file.has_parent_path()) make_folder(file.parent_path());
    if (fs::exists(file)) refuse_changed_records(study.source, plan, file);
    catch_interrupts();
    const std::vector<std::uint32_t> sizes = wall_sizes(study.geometry, study, plan, file);
    const SamplePlan samples =
        sample_plan(study, study.load, study.source, ready.layout, sizes);
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
