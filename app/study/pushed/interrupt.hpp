#pragma once
/// Ctrl-C and a request to end: the run stops, keeps what it has, and says so in one sentence.

#include <string>

namespace app {

/// A Ctrl-C ends the program at once, with a sentence and kInterruptedCode: for what takes no
/// time worth keeping.
void end_at_ctrl_c();

/// Notes SIGINT, SIGTERM, SIGHUP, SIGQUIT and, from batch systems, SIGUSR1, instead of dying of
/// them. A SIGINT or SIGQUIT that comes a second or more after the first signal ends the
/// program at once: what runs then is not put away. Signals that were ignored when the program
/// was started, as by nohup, stay so.
void catch_interrupts();

/// Whether one was noted.
[[nodiscard]] bool interrupted();

/// Exit code of a program that was told to end.
inline constexpr int kInterruptedCode = 130;

/// Thrown where a run stops because of it, and caught by main() alone. It is no std::exception,
/// so that no handler of errors takes it for one.
struct Interrupted {
    std::string kept = "nothing was written"; ///< a clause: what is left of the run
};

/// @throws Interrupted if a signal was noted
void end_if_interrupted();

} // namespace app
