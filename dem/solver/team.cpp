#include "dem/solver/team.hpp"

#include <algorithm>
#include <thread>
#include <vector>

namespace dem {

namespace {

int team_size(int threads)
{
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    return threads > 0 ? threads : static_cast<int>(cores);
}

} // namespace

int lanes_wanted(std::size_t walls, int threads)
{
    const auto teams = static_cast<std::size_t>(team_size(threads));
    return static_cast<int>(std::min<std::size_t>(1000, walls / teams + (walls % teams != 0)));
}

void Team::note_trouble()
{
    if (!trouble_) trouble_ = std::current_exception();
    ended_ = true;
}

void Team::one_at_a_time(const std::function<void()>& hand_over)
{
    const std::lock_guard lock(mutex_);
    if (trouble_) std::rethrow_exception(trouble_);
    try {
        hand_over();
    } catch (...) {
        note_trouble(); // before another thread has its turn
        throw;
    }
}

void Team::run(int threads, const std::function<void()>& work)
{
    const auto guarded = [&] {
        try {
            work();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            note_trouble();
        }
    };
    {
        std::vector<std::jthread> others;
        for (int t = 1; t < team_size(threads); ++t) others.emplace_back(guarded);
        guarded();
    }
    if (trouble_) std::rethrow_exception(trouble_);
}

} // namespace dem
