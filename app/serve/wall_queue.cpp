#include "app/serve/wall_queue.hpp"

#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/wall_frames.hpp"

#include <chrono>
#include <limits>
#include <map>
#include <utility>

namespace app {
namespace {

using namespace std::chrono_literals;

/// Requests sent together arrive one by one; the first waits this long for the rest. A push
/// takes a hundred times longer.
constexpr auto kGather = 2ms; // choice
constexpr auto kLook = 100ms; // between looks whether the program is told to end

/// More than will ever be asked for.
constexpr std::size_t kNoEnd = std::numeric_limits<std::size_t>::max() / 2;

} // namespace

WallQueue::WallQueue(const Study& study, const dem::Model& model, int threads)
    : study_(study), model_(model), threads_(static_cast<std::size_t>(threads))
{
    for (int i = 0; i < threads; ++i) team_.emplace_back([this] { work(); });
}

WallQueue::~WallQueue()
{
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    arrived_.notify_all();
    team_.clear();
    give_up();
}

PushedWall WallQueue::push(WantedWall wall)
{
    std::future<PushedWall> answer;
    {
        const std::lock_guard lock(mutex_);
        if (closed_ || interrupted()) throw Interrupted();
        waiting_.push_back({std::move(wall), {}});
        answer = waiting_.back().answer.get_future();
    }
    arrived_.notify_one();
    return answer.get();
}

void WallQueue::work()
{
    while (wait_for_walls()) {
        try {
            push_waiting();
        } catch (const Interrupted&) {
            break;
        } catch (const std::exception&) { // who asked has it
        }
    }
    give_up();
}

/// @return false once there is an end to it
bool WallQueue::wait_for_walls()
{
    std::unique_lock lock(mutex_);
    while (waiting_.empty() && !closed_ && !interrupted()) arrived_.wait_for(lock, kLook);
    if (closed_ || interrupted()) return false;
    lock.unlock();
    std::this_thread::sleep_for(kGather);
    return true;
}

std::optional<WallQueue::Asked> WallQueue::take()
{
    const std::lock_guard lock(mutex_);
    if (closed_) throw Interrupted();
    if (waiting_.empty()) return {};
    Asked first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
}

/// A wall alone is pushed in plain doubles. Several share a register, and those that come
/// meanwhile take its free lanes.
void WallQueue::push_waiting()
{
    std::map<std::size_t, std::promise<PushedWall>> running; // touched by this thread alone
    PushList list;
    {
        const std::lock_guard lock(mutex_);
        const bool alone = waiting_.size() <= threads_;
        list.size = alone ? 1 : kNoEnd;
        list.open = !alone;
    }
    list.wall = [&](std::size_t i) -> std::optional<WantedWall> {
        std::optional<Asked> asked = take();
        if (!asked) return {};
        running.emplace(i, std::move(asked->answer));
        return std::move(asked->wall);
    };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        running.extract(i).mapped().set_value(std::move(wall));
    };
    try {
        dem::PushPlan plan = bare(push_plan(study_));
        plan.progress = [](const dem::PushProgress&) { end_if_interrupted(); };
        push_walls(study_, model_, plan, list, 1);
    } catch (...) {
        for (auto& [i, answer] : running) answer.set_exception(std::current_exception());
        throw;
    }
}

void WallQueue::give_up()
{
    const std::lock_guard lock(mutex_);
    closed_ = true;
    for (Asked& asked : waiting_)
        asked.answer.set_exception(std::make_exception_ptr(Interrupted()));
    waiting_.clear();
}

} // namespace app
