#include "app/study/slurm_command.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/replaced_file.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/push_layouts.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/layout.hpp"
#include "dem/solver/solver_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double kShardSeconds = 1800.0;
constexpr double kMostShards = 1000.0;

constexpr std::string_view kHead = R"sh(#!/usr/bin/env bash
# The shards of a study as a Slurm job array, and their merge. Submit: bash THIS_FILE [options of sbatch]
# A task that was killed or lost its node is requeued and resumes its file.
set -euo pipefail

)sh";

/// Part of the script that follows the values of the variables.
constexpr std::string_view kScript = R"sh(
if [[ -z ${SLURM_JOB_ID-} ]]; then # on the login node
    mkdir -p -- "$logs"
    script=$(readlink -f -- "${BASH_SOURCE[0]}")
    folder=${logs//%/%%} # sbatch replaces %a
    array=$(sbatch --parsable --job-name=drystone --array=1-"$shards" --requeue \
        --open-mode=append --nodes=1 --ntasks=1 --cpus-per-task="$threads" --time="$minutes" \
        --signal=B:USR1@60 --output="$folder/%a.log" "$@" "$script")
    merge=$(sbatch --parsable --job-name=drystone-merge --dependency=afterany:"$array" \
        --requeue --open-mode=append --ntasks=1 --output="$folder/merge.log" "$@" "$script" merge)
    echo "array $array, merge $merge; logs in $logs"
    exit 0
fi

if [[ ${1-} == merge ]]; then
    files=()
    for ((i = 1; i <= shards; ++i)); do
        files+=("$(printf '%s_%0*d_of_%s%s' "$stem" "${#shards}" "$i" "$shards" "$ending")")
    done
    ((shards == 1)) || "$program" merge "$out" "${files[@]}"
    exit
fi

# A minute before its time is over the program is told to end, and the task asks for another turn.
child=0
trap '((child == 0)) || kill -TERM "$child"' USR1
"$program" study "$study" --out "$out" --shard "$SLURM_ARRAY_TASK_ID/$shards" \
    --threads "${SLURM_CPUS_PER_TASK:-1}" --quiet "${options[@]}" &
child=$!
code=0
wait "$child" || code=$?
if ((code > 128)); then # the signal ended the wait, not the program
    code=0
    wait "$child" || code=$?
fi
if ((code != 0 && code != 2)) && ((${SLURM_RESTART_COUNT:-0} < 3)); then
    echo "shard $SLURM_ARRAY_TASK_ID ended with $code, another turn"
    scontrol requeue "$SLURM_JOB_ID"
fi
exit "$code"
)sh";

/// As one word of a shell.
std::string quoted(const std::string& text)
{
    constexpr Replacement kQuote[] = {{"'", "'\\''"}};
    return "'" + replaced(text, kQuote) + "'";
}

/// Twice the expected time and a quarter of an hour, at least one hour.
int limit_minutes(double expected)
{
    return static_cast<int>(std::ceil(std::max(60.0, 2.0 * expected + 15.0)));
}

std::size_t wall_count(const Masonry& masonry, const LoadInput& load, const Sampling& sampling)
{
    return load.vertical_stress.size() * samples_of(masonry.geometry, sampling);
}

/// Walls that would take as long as all pushes of the study and of its audit.
double effort(const PreparedStudy& ready)
{
    const Study& study = ready.study;
    const std::uint32_t audit =
        std::min<std::uint32_t>(samples_of(study.geometry, study), study.uq.audit);
    const double ways =
        pushes_both_ways(study.geometry, study.load, study.source, ready.layout) ? 2.0 : 1.0;
    return ways * static_cast<double>(wall_count(study, study.load, study)) +
           static_cast<double>(study.load.vertical_stress.size()) * audit * kAuditSlower;
}

/// Shards so that one takes about half an hour, at least one wall in each.
int shard_count(const StudyWork& work, int threads)
{
    const auto most =
        static_cast<int>(std::min(kMostShards, std::max(1.0, static_cast<double>(work.runs))));
    int n = 1;
    while (n < most && seconds_of(work, n) > kShardSeconds * threads * n) ++n;
    return n;
}

/// [s] of one core for a wall, from the first walls of the study under all its levels.
double seconds_per_wall(const PreparedStudy& ready)
{
    const Study& study = ready.study;
    const std::vector<std::uint32_t> sizes = {samples_of(study.geometry, study)};
    const SamplePlan plan = sample_plan(study, study.load, study.source, ready.layout, sizes);
    const int levels = static_cast<int>(study.load.vertical_stress.size());
    PushList pilot;
    pilot.size =
        std::min<std::size_t>(dem::solver_lanes(), wall_count(study, study.load, study));
    pilot.wall = [&](std::size_t i) -> WantedWall {
        const int level = static_cast<int>(i) % levels, sample = static_cast<int>(i) / levels;
        return {level, draw(plan, level, sample)};
    };
    double seconds = 0.0;
    pilot.done = [&](std::size_t, const WallDraw&, PushedWall&& wall) {
        seconds += wall.result.cost.seconds;
    };
    push_in_layouts(
        ready, bare(push_plan(study)), pilot,
        [&](std::size_t i) {
            return static_cast<std::uint32_t>(i) / static_cast<std::uint32_t>(levels);
        },
        1);
    return seconds / static_cast<double>(pilot.size);
}

/// A bash script; run, it submits two jobs: the array, and a merge that waits for all of its
/// tasks.
/// @param minutes expected for one shard
std::string slurm_script(const Command& command, int shards, double minutes)
{
    const fs::path out = fs::absolute(command.out);
    std::string text(kHead);
    const auto put = [&text](const char* name, const std::string& value) {
        text += std::string(name) + "=" + value + "\n";
    };
    put("program", quoted(fs::canonical("/proc/self/exe").string()));
    put("study", quoted(fs::absolute(command.study).string()));
    put("out", quoted(out.string()));
    put("stem", quoted((out.parent_path() / out.stem()).string()));
    put("ending", quoted(out.extension().string()));
    put("logs", quoted(out.string() + ".logs"));
    put("shards", std::to_string(shards));
    put("threads", std::to_string(command.threads));
    put("minutes", std::to_string(limit_minutes(minutes)));
    std::string options;
    for (const std::string& o : command.overrides) options += " --set " + quoted(o);
    put("options", "(" + options + " )");
    return text + std::string(kScript);
}

} // namespace

double pushes_of(const StudyWork& work, int shards)
{
    if (work.pushed == 0) return 0.0;
    const double pushed = static_cast<double>(work.pushed),
                 runs_of_wall = static_cast<double>(work.runs) / pushed;
    return pushed * std::min(runs_of_wall, static_cast<double>(shards));
}

double seconds_of(const StudyWork& work, int shards)
{
    return work.all + pushes_of(work, shards) * work.each_push;
}

StudyWork pushing_work(const PreparedStudy& ready)
{
    const double each = seconds_per_wall(ready);
    return {wall_count(ready.study, ready.study.load, ready.study),
            "walls",
            each,
            effort(ready) * each,
            0,
            0.0};
}

int write_slurm_script(const StudyWork& work, const Command& command)
{
    if (const std::string note = check_replaced(command.script, kHead); !command.quiet)
        std::cerr << note;
    const int shards =
        command.shard.count > 1 ? command.shard.count : shard_count(work, command.threads);
    const double minutes = seconds_of(work, shards) / 60.0 / shards / command.threads;
    const fs::path file = command.script;
    if (file.has_parent_path()) make_folder(file.parent_path());
    write_file(file, slurm_script(command, shards, minutes));
    std::cout << work.runs << " " << work.name << " of " << number(work.each, 2) << " s, ";
    if (work.pushed > 0)
        std::cout << number(pushes_of(work, shards), 9) << " pushes of "
                  << number(work.each_push, 2) << " s, ";
    std::cout << shards << " shards of about " << fixed(minutes, 1) << " minutes on "
              << command.threads << " threads; submit with: bash " << command.script << '\n';
    return 0;
}

} // namespace app
