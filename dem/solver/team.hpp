#pragma once
/// Threads that do the same work and end together: the first exception in any of them is thrown
/// to the caller.

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace dem {

class Team {
  public:
    /// Runs `work` in so many threads, of which the caller's is one. @param threads 0: as many
    /// as the machine has cores
    void run(int threads, const std::function<void()>& work);

    /// Calls `hand_over` while no other thread does. Throws what another thread has met, so
    /// that this one ends as well.
    void one_at_a_time(const std::function<void()>& hand_over);

    /// Whether a thread has met an exception: the others may leave their work.
    [[nodiscard]] bool ended() const { return ended_; }

  private:
    void note_trouble();

    std::mutex mutex_;
    std::exception_ptr trouble_;
    std::atomic<bool> ended_{false};
};

/// Lanes that each thread takes, so that the others have work as well where walls are few.
[[nodiscard]] int lanes_wanted(std::size_t walls, int threads);

} // namespace dem
