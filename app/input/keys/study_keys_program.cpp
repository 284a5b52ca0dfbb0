/// Another program as the model: keys of the study file.

#include "app/input/keys/study_key_table.hpp"

#include <array>
#include <vector>

namespace app {
namespace {

constexpr std::array kKeeps = {named("none", KeepRuns::none), named("failed", KeepRuns::failed),
                               named("all", KeepRuns::all)};
constexpr std::array kEvents = {named("below", false), named("above", true)};

// clang-format off
constexpr std::array kProgramKeys = {
    Key{.name = "model.command", .kind = Kind::text, .example = "./model {input} {output}",
        .meaning = "program and its arguments, run without a shell (docs/external_program.md)",
        .field = kAt<&Study::program, &ProgramInput::command>},
    Key{.name = "model.responses", .kind = Kind::text, .example = "capacity",
        .meaning = "names of the numbers that the program answers, between commas",
        .field = kAt<&Study::program, &ProgramInput::responses>},
    Key{.name = "model.concurrent", .kind = Kind::count, .range = {'[', 1, 1024, ']'},
        .derived = {"--threads"},
        .meaning = "runs at a time; no result depends on it",
        .field = kAt<&Study::program, &ProgramInput::concurrent>},
    Key{.name = "model.time_limit", .unit = "s", .range = {'(', 0, 1e8, ']'},
        .derived = {"none"},
        .meaning = "time limit of one run; a run that takes longer is ended and has failed",
        .field = kAt<&Study::program, &ProgramInput::time_limit>},
    Key{.name = "model.grace", .unit = "s", .range = {'[', 0, 1e6, ']'},
        .meaning = "time that a run has to end after SIGTERM, before SIGKILL",
        .field = kAt<&Study::program, &ProgramInput::grace>},
    Key{.name = "model.retries", .kind = Kind::count, .range = {'[', 0, 1000, ']'},
        .meaning = "further tries of a run that failed",
        .field = kAt<&Study::program, &ProgramInput::retries>},
    Key{.name = "model.keep", .kind = Kind::word, .names = kKeeps,
        .meaning = "directories of runs that stay for inspection",
        .field = kAt<&Study::program, &ProgramInput::keep>},

    Key{.name = "reliability.response", .kind = Kind::text, .derived = {"the first"},
        .meaning = "one of model.responses",
        .field = kAt<&Study::program, &ProgramInput::response>},
    Key{.name = "reliability.demand", .range = {'[', -1e300, 1e300, ']'}, .example = "40",
        .meaning = "demand in the unit of the program",
        .field = kAt<&Study::program, &ProgramInput::demand>},
    Key{.name = "reliability.event", .kind = Kind::word, .names = kEvents,
        .meaning = "the response falls to the demand or below, or reaches it or goes above",
        .field = kAt<&Study::program, &ProgramInput::above>},
};
// clang-format on

} // namespace

std::span<const Key> program_keys()
{
    static const std::vector<Key> all = [] {
        std::vector<Key> keys(kProgramKeys.begin(), kProgramKeys.end());
        for (const char* const shared : {"reliability.method", "reliability.budget",
                                         "reliability.target_cov", "uq.seed", "uq.pearson"})
            keys.push_back(*find_key(shared));
        return keys;
    }();
    return all;
}

} // namespace app
