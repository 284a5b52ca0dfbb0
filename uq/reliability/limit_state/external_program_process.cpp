#include "uq/reliability/limit_state/external_program_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace uq {

namespace {

std::vector<std::string> environment(const Launch& launch)
{
    std::vector<std::string> all;
    for (char** e = environ; *e != nullptr; ++e) {
        const std::string entry = *e;
        const std::string key = entry.substr(0, entry.find('='));
        if (std::ranges::none_of(launch.environment,
                                 [&](const auto& added) { return added.first == key; }))
            all.push_back(entry);
    }
    for (const auto& [key, value] : launch.environment) all.push_back(key + "=" + value);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& text)
{
    std::vector<char*> p;
    for (std::string& t : text) p.push_back(t.data());
    p.push_back(nullptr);
    return p;
}

/// Everything the child needs, made before the fork: after it, only calls that are safe then.
struct Prepared {
    std::vector<std::string> words, variables;
    std::vector<char*> argv, envp;
    std::string directory, input, output, errors;
    pid_t parent;

    explicit Prepared(const Launch& l)
        : words(l.command), variables(environment(l)), argv(pointers(words)),
          envp(pointers(variables)), directory(l.directory), input(l.input), output(l.output),
          errors(l.errors), parent(getpid())
    {
    }
};

bool redirect(const std::string& file, int flags, int to)
{
    const int fd = open(file.c_str(), flags | O_CLOEXEC, 0644);
    return fd >= 0 && dup2(fd, to) >= 0;
}

[[noreturn]] void become(const Prepared& p, int report)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL); // not left alone if the analysis is killed
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    signal(SIGPIPE, SIG_DFL);
    if (getppid() == p.parent && redirect(p.input, O_RDONLY, 0) &&
        redirect(p.output, O_WRONLY | O_CREAT | O_TRUNC, 1) &&
        redirect(p.errors, O_WRONLY | O_CREAT | O_TRUNC, 2) && chdir(p.directory.c_str()) == 0)
        execvpe(p.argv[0], p.argv.data(), p.envp.data());
    const int error = errno;
    [[maybe_unused]] const ssize_t sent = write(report, &error, sizeof error);
    _exit(127);
}

[[noreturn]] void refuse(const Launch& launch, int error)
{
    throw std::runtime_error("cannot run " + launch.command.front() + ": " +
                             std::strerror(error));
}

} // namespace

Process::Process(const Launch& launch)
{
    const Prepared prepared(launch);
    std::array<int, 2> report{};
    if (pipe2(report.data(), O_CLOEXEC) != 0) refuse(launch, errno);
    pid_ = fork();
    if (pid_ == 0) become(prepared, report[1]);
    const int fork_error = errno;
    close(report[1]);
    int error = 0;
    ssize_t got = 0;
    do got = pid_ < 0 ? 0 : read(report[0], &error, sizeof error); // ends when it runs
    while (got < 0 && errno == EINTR);
    close(report[0]);
    if (pid_ < 0) refuse(launch, fork_error);
    if (got <= 0) return;
    waitpid(pid_, &status_, 0);
    pid_ = -1;
    refuse(launch, error);
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), status_(other.status_)
{
}

Process& Process::operator=(Process&& other) noexcept
{
    std::swap(pid_, other.pid_);
    std::swap(status_, other.status_);
    return *this;
}

Process::~Process()
{
    if (pid_ < 0) return;
    signal_group(SIGKILL);
    waitpid(pid_, &status_, 0);
}

bool Process::ended()
{
    if (pid_ < 0) return true;
    // Looked at before it is reaped: until then its number, and its group's, is no one else's.
    siginfo_t info{};
    const int looked =
        waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    if (looked != 0 || info.si_pid != pid_) return false;
    signal_group(SIGKILL);
    waitpid(pid_, &status_, 0);
    pid_ = -1;
    return true;
}

void Process::signal_group(int signal) const
{
    if (pid_ > 0) kill(-pid_, signal);
}

std::string Process::failure() const
{
    if (WIFSIGNALED(status_))
        return "signal " + std::to_string(WTERMSIG(status_)) + " (" +
               strsignal(WTERMSIG(status_)) + ")";
    const int code = WEXITSTATUS(status_);
    return code == 0 ? "" : "exit code " + std::to_string(code);
}

} // namespace uq
