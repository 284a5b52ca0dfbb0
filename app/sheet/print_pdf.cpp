#include "app/sheet/print_pdf.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

extern char** environ; // NOLINT: POSIX names it so

namespace app {
namespace {

/// Exit code of a program with two arguments whose output is thrown away; -1: there is no such
/// program.
int run(const char* program, const std::string& first, const std::string& second)
{
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&files, stream, "/dev/null",
                                           stream == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0);
    std::string name = program, a = first, b = second;
    char* const arguments[] = {name.data(), a.data(), b.data(), nullptr};
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, program, &files, nullptr, arguments, environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (error != 0) return -1;
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return 1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

} // namespace

std::string print_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf)
{
    constexpr int kNotFound = 127; // of shells and of spawned programs that are not there
    std::filesystem::path part = pdf;
    part += ".part"; // appears complete or not at all
    const int code = run("weasyprint", html.string(), part.string());
    std::error_code error;
    if (code == 0) std::filesystem::rename(part, pdf, error);
    if (code == 0 && !error) return pdf.string() + " written";
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    if (code == -1 || code == kNotFound)
        return "no PDF: install WeasyPrint (Debian: apt install weasyprint), or print the page "
               "from a browser";
    return "no PDF: WeasyPrint failed; print the page from a browser";
}

} // namespace app
