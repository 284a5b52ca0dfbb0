#pragma once
/// A process of its own for what a test kills or limits.

#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace scenes {

/// Runs `work` in a fork and never comes back from there; 0 as exit code unless it throws (1)
/// or says so.
inline pid_t start_child(const std::function<int()>& work)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    int code = 1;
    try {
        code = work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "child: %s\n", error.what());
    }
    ::_exit(code);
}

/// Exit code, or minus the signal that ended it.
inline int wait_for(pid_t child)
{
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace scenes
