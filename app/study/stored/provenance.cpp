#include "app/study/stored/provenance.hpp"

#include "app/program_version.hpp"
#include "dem/solver/solver_lanes.hpp"
#include "dem/solver/solver_revision.hpp"

#include <ctime>
#include <fstream>
#include <string>

#include <unistd.h>

namespace app {
namespace {

std::string host()
{
    char name[256] = "";
    return gethostname(name, sizeof name - 1) == 0 ? name : "unknown host";
}

std::string processor()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string now()
{
    const std::time_t t = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&t, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

std::string compiler()
{
#ifdef __clang__
    return std::string("clang++ ") + __clang_version__;
#else
    return std::string("g++ ") + __VERSION__;
#endif
}

} // namespace

StoreSession this_session(int threads)
{
    return {program_version(),
            host() + ", " + processor(),
            compiler() + ", " + std::to_string(dem::solver_lanes()) + " lanes",
            std::to_string(threads) + " threads",
            now(),
            std::to_string(dem::kSolverRevision)};
}

} // namespace app
