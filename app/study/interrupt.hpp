#pragma once
/// Ctrl-C and a request to end: the run stops at the next wall and keeps what it has.

namespace app {

/// Notes SIGINT, SIGTERM, SIGHUP and, from batch systems, SIGUSR1, instead of dying of them; a second SIGINT
/// ends the program at once.
void catch_interrupts();

/// Whether one was noted.
[[nodiscard]] bool interrupted();

/// Thrown where a run stops because of it.
struct Interrupted {};

} // namespace app
