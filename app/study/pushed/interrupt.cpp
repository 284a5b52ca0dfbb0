#include "app/study/pushed/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <string_view>

#include <unistd.h>

namespace app {
namespace {

constexpr long long kPatience = 1000; // [ms] choice: the first signal needs less to end a run

std::atomic<long long> noted_at{0}; // [ms] of a clock that never goes backwards; 0: not yet
static_assert(std::atomic<long long>::is_always_lock_free, "written by a signal handler");

long long clock_ms()
{
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000LL + now.tv_nsec / 1'000'000 + 1;
}

void note(int signal)
{
    const long long now = clock_ms();
    long long first = 0;
    if (noted_at.compare_exchange_strong(first, now)) return;
    const bool of_a_person = signal == SIGINT || signal == SIGQUIT;
    if (of_a_person && now - first >= kPatience) std::_Exit(kInterruptedCode);
}

[[noreturn]] void end(int)
{
    constexpr std::string_view kSentence = "drystone: interrupted; no result was finished\n";
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, kSentence.data(), kSentence.size());
    std::_Exit(kInterruptedCode);
}

void take(int signal, void (*handler)(int))
{
    if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

} // namespace

void end_at_ctrl_c() { take(SIGINT, end); }

void catch_interrupts()
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1}) take(signal, note);
}

bool interrupted() { return noted_at != 0; }

void end_if_interrupted()
{
    if (interrupted()) throw Interrupted();
}

} // namespace app
