#include "bench/machine.hpp"

#include "dem/contact/pack.hpp"

#include <cctype>
#include <fstream>
#include <string_view>
#include <thread>

namespace bench {

namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "clang++ " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

#if defined(__AVX512F__)
constexpr const char* kRegisters = "AVX-512";
#elif defined(__AVX2__)
constexpr const char* kRegisters = "AVX2";
#else
constexpr const char* kRegisters = "SSE2";
#endif

/// Text after "key :" in a file of such lines; empty where there is none.
std::string value_of(const char* file, std::string_view key)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos || !line.starts_with(key)) continue;
        if (line.find_first_not_of(" \t", key.size()) != colon) continue; // a longer key
        const std::size_t value = line.find_first_not_of(" \t", colon + 1);
        return value == std::string::npos ? "" : line.substr(value);
    }
    return {};
}

std::string first_word(const std::string& file)
{
    std::ifstream in(file);
    std::string word;
    in >> word;
    return word;
}

} // namespace

std::string machine_line()
{
    constexpr const char* kInfo = "/proc/cpuinfo";
    std::string cpu = value_of(kInfo, "model name");
    if (cpu.empty()) cpu = "unknown processor";
    const std::string family = value_of(kInfo, "cpu family"), model = value_of(kInfo, "model");
    if (!model.empty()) cpu += " (family " + family + ", model " + model + ")";
    return cpu + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " +
           kCompiler + " " DRYSTONE_COMPILER_FLAGS ", " + kRegisters + " (" +
           std::to_string(dem::lanes<dem::Pack>) + " lanes)";
}

std::string command_line()
{
    std::ifstream in("/proc/self/cmdline");
    std::string all;
    for (std::string word; std::getline(in, word, '\0');) {
        const std::size_t build = all.empty() ? word.rfind("/build/") : std::string::npos;
        if (!all.empty()) all += ' ';
        all += build == std::string::npos ? word : word.substr(build + 1);
    }
    return all;
}

std::string cache_line()
{
    std::string all;
    for (int i = 0; i < 8; ++i) {
        const std::string at =
            "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(i) + "/";
        const std::string type = first_word(at + "type"), size = first_word(at + "size");
        if (size.empty() || type == "Instruction") continue;
        const std::string level = "L" + first_word(at + "level") + (type == "Data" ? "d" : "");
        all += (all.empty() ? "" : ", ") + level + " " + size;
    }
    return all;
}

double peak_memory_mb()
{
    const std::string kilobytes = value_of("/proc/self/status", "VmHWM");
    if (kilobytes.empty()) return 0.0;
    return std::stod(kilobytes) / 1024.0;
}

bool reset_peak_memory()
{
    std::ofstream out("/proc/self/clear_refs");
    out << "5" << std::flush;
    return out.good();
}

} // namespace bench
