#include "dem/shaking/shake_ensemble.hpp"

#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/shaking/history_run.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/team.hpp"
#include "dem/solver/thread_time.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

constexpr long long kAskEvery = 64; // steps between looks at the other threads

/// The histories of one thread, side by side.
template <class Real> class HistoryBatch {
  public:
    using Next = std::function<std::optional<HistoryRun>()>;
    using Done = std::function<void(std::size_t, ShakeResult&&)>;

    HistoryBatch(const ShakenTask& task, bool damps, const Next& next, const Done& done)
        : task_(task), next_(next), done_(done),
          walls_(empty_shaken<Real>(task.model, task.tables, damps))
    {
        for (int i = 0; i < lanes<Real>; ++i) clear_lane(task.tables, i, walls_);
    }

    void run(int most_lanes, const Team& team)
    {
        for (int i = 0; i < std::min(most_lanes, lanes<Real>); ++i) fill(i);
        for (long long steps = 1; running_ > 0; ++steps) {
            ShakingInput<Real> in; // a lane without a wall stays at rest
            for (int i = 0; i < lanes<Real>; ++i)
                if (runs_[i]) set_input(runs_[i]->next(), i, in);
            shaking_step(task_.tables, task_.options, in, walls_);
            for (int i = 0; i < lanes<Real>; ++i) {
                if (!runs_[i] || runs_[i]->look(walls_, i)) continue;
                hand_out(i);
                fill(i);
            }
            if (steps % kAskEvery == 0 && team.ended()) return;
        }
    }

  private:
    static void set_input(const ShakingInput<double>& one, int lane, ShakingInput<Real>& in)
    {
        set_lane(in.x, lane, one.x);
        set_lane(in.z, lane, one.z);
        set_lane(in.kick, lane, one.kick);
    }

    /// Charges the time since the last call to the histories that run.
    void share_time()
    {
        const double now = thread_seconds();
        for (auto& run : runs_)
            if (run) run->spend((now - last_) / running_);
        last_ = now;
    }

    void hand_out(int lane)
    {
        share_time();
        HistoryRun& run = *runs_[lane];
        done_(run.number(), run.finish(walls_, lane));
        runs_[lane].reset();
        --running_;
        clear_lane(task_.tables, lane, walls_);
    }

    /// Puts the next history into a free lane, if there is one.
    void fill(int lane)
    {
        while (std::optional<HistoryRun> run = next_()) {
            share_time();
            runs_[lane] = std::move(run);
            ++running_;
            if (runs_[lane]->load(walls_, lane)) return;
            hand_out(lane);
        }
    }

    const ShakenTask& task_;
    const Next& next_;
    const Done& done_;
    ShakenWalls<Real> walls_;
    std::array<std::optional<HistoryRun>, lanes<Real>> runs_;
    int running_ = 0;
    double last_ = thread_seconds();
};

} // namespace

void shake_ensemble(const Model& model, const ShakenEnsemble& ensemble,
                    const SolverOptions& options, const Workers& workers)
{
    check_shaken(model);
    const StepTables tables = step_tables(model);
    const ShakenTask task{model, tables, options};
    std::atomic<std::size_t> waiting{0};
    Team team;
    const auto next = [&]() -> std::optional<HistoryRun> {
        for (std::size_t number = waiting++; number < ensemble.size; number = waiting++)
            if (std::optional<HistoryInput> h = ensemble.history(number)) {
                check(model, h->materials);
                if ((h->plan.contact_damping > 0.0) != ensemble.damps)
                    throw std::invalid_argument(
                        "all histories of an ensemble have contact damping, or none has");
                return HistoryRun(task, number, std::move(h->materials), std::move(h->plan));
            }
        return {};
    };
    const auto done = [&](std::size_t number, ShakeResult&& result) {
        team.one_at_a_time([&] { ensemble.done(number, std::move(result)); });
    };
    const auto work = [&]<class Real>() {
        HistoryBatch<Real>(task, ensemble.damps, next, done)
            .run(lanes_wanted(ensemble.size, workers.threads), team);
    };
    team.run(workers.threads, [&] {
        workers.scalar ? work.template operator()<double>() : work.template operator()<Pack>();
    });
}

ShakeResult shake(const Model& model, const WallMaterials& materials, const ShakePlan& plan,
                  const SolverOptions& options)
{
    ShakeResult result;
    ShakenEnsemble one;
    one.size = 1;
    one.damps = plan.contact_damping > 0.0;
    one.history = [&](std::size_t) { return HistoryInput{materials, plan}; };
    one.done = [&](std::size_t, ShakeResult&& r) { result = std::move(r); };
    shake_ensemble(model, one, options, {.threads = 1, .scalar = true});
    return result;
}

} // namespace dem
