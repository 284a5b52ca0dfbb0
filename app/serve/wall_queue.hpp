#pragma once
/// Walls that are asked for one by one, from many threads, and pushed side by side in the lanes
/// of a register.

#include "app/study/pushed/push_walls.hpp"

#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace app {

class WallQueue {
  public:
    /// @param study, model outlive the queue
    /// @param threads >= 1
    WallQueue(const Study& study, const dem::Model& model, int threads);
    /// Leaves the walls on their way.
    ~WallQueue();

    /// Waits for the wall, which has the bits that it has in a study.
    /// @throws Interrupted once the program is told to end
    [[nodiscard]] PushedWall push(WantedWall wall);

  private:
    struct Asked {
        WantedWall wall;
        std::promise<PushedWall> answer;
    };

    void work();
    [[nodiscard]] bool wait_for_walls();
    void push_waiting();
    [[nodiscard]] std::optional<Asked> take();
    void give_up();

    const Study& study_;
    const dem::Model& model_;
    std::size_t threads_;
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<Asked> waiting_;
    bool closed_ = false;
    std::vector<std::jthread> team_;
};

} // namespace app
