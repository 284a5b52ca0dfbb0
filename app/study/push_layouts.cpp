#include "app/study/push_layouts.hpp"

#include "app/input/keys/limit_state_text.hpp"

#include "app/input/wall/random_layouts.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace app {
namespace {

/// A layout and the walls in it, by their places in the list.
struct Group {
    std::uint32_t seed = 0;
    std::vector<std::size_t> walls;
};

/// In the order of their first walls.
std::vector<Group> groups_of(const Masonry& masonry, std::size_t size, const SampleOf& sample)
{
    std::vector<Group> groups;
    std::map<std::uint32_t, std::size_t> places;
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint32_t seed = layout_seed(masonry, sample(i));
        const auto [at, first] = places.try_emplace(seed, groups.size());
        if (first) groups.push_back({seed, {}});
        groups[at->second].walls.push_back(i);
    }
    return groups;
}

/// State shared by the threads of one call. The first exception stops them all, each at its
/// next wall.
class LayoutRun {
  public:
    LayoutRun(const Study& study, const dem::PushPlan& plan, const PushList& list,
              std::vector<Group> groups, int threads)
        : study_(study), plan_(plan), list_(list), groups_(std::move(groups)),
          workers_(std::min<std::size_t>(groups_.size(), static_cast<std::size_t>(threads))),
          threads_(std::max(1, threads / static_cast<int>(std::max<std::size_t>(1, workers_))))
    {
    }

    void run()
    {
        std::vector<std::thread> workers;
        for (std::size_t k = 1; k < workers_; ++k) workers.emplace_back([this] { work(); });
        work();
        for (std::thread& w : workers) w.join();
        if (fault_) std::rethrow_exception(fault_);
    }

  private:
    struct Left {}; ///< another thread has met a fault

    void work()
    {
        try {
            for (std::size_t g = next_++; g < groups_.size(); g = next_++) push(groups_[g]);
        } catch (const Left&) {
        } catch (...) {
            const std::lock_guard lock(mutex_);
            end();
        }
    }

    /// With the lock held, while an exception is handled.
    void end()
    {
        if (!fault_) fault_ = std::current_exception();
        ended_ = true;
    }

    /// Hands a wall on. The run has ended before another thread can hand on the next one, if
    /// this fails.
    void hand_on(std::size_t i, const WallDraw& draw, PushedWall&& wall)
    {
        const std::lock_guard lock(mutex_);
        if (ended_) throw Left();
        try {
            list_.done(i, draw, std::move(wall));
        } catch (...) {
            end();
            throw;
        }
    }

    void push(const Group& group)
    {
        if (ended_) throw Left();
        std::optional<PreparedStudy> own;
        std::optional<dem::Model> model;
        try {
            own = in_layout(study_, group.seed);
            model = model_of(*own);
        } catch (const ConfigError& bad) {
            return refuse(group, bad.what());
        } catch (const std::invalid_argument& bad) {
            return refuse(group, bad.what());
        }
        PushList part;
        part.size = group.walls.size();
        part.wall = [&](std::size_t i) {
            if (ended_) throw Left();
            return list_.wall(group.walls[i]);
        };
        part.done = [&](std::size_t i, const WallDraw& draw, PushedWall&& wall) {
            hand_on(group.walls[i], draw, std::move(wall));
        };
        push_walls(own->study, *model, plan_, part, threads_);
    }

    void refuse(const Group& group, const std::string& why)
    {
        for (const std::size_t i : group.walls) {
            const std::optional<WantedWall> wanted = list_.wall(i);
            if (wanted)
                hand_on(i, wanted->draw,
                        no_wall(reading_rules(study_), study_.load, wanted->level, why));
        }
    }

    const Study& study_;
    const dem::PushPlan& plan_;
    const PushList& list_;
    const std::vector<Group> groups_;
    const std::size_t workers_; ///< layouts at a time
    const int threads_;         ///< of each of them
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> ended_{false};
    std::mutex mutex_;
    std::exception_ptr fault_;
};

} // namespace

void push_in_layouts(const PreparedStudy& ready, const dem::PushPlan& plan,
                     const PushList& list, const SampleOf& sample, int threads)
{
    const Study& study = ready.study;
    if (list.size == 0) return;
    if (!has_layouts(study.geometry))
        return push_walls(study, model_of(ready), plan, list, threads);
    LayoutRun(study, plan, list, groups_of(study, list.size, sample), threads).run();
}

} // namespace app
