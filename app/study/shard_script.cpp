#include "app/study/shard_script.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace app {
namespace {

constexpr double kShardSeconds = 1800.0;
constexpr double kMostShards = 1000.0;

// clang-format off
constexpr const char* kScript = R"sh(#!/usr/bin/env bash
# Shards of a study as a Slurm job array, and their merge. Submit: bash THIS_FILE [options of sbatch]
# A task that was killed or lost its node is requeued and goes on with what its file has.
set -euo pipefail

program=@program@
study=@study@
out=@out@
logs=@logs@
shards=@shards@

if [[ -z ${SLURM_JOB_ID-} ]]; then # on the login node
    mkdir -p -- "$logs"
    script=$(readlink -f -- "${BASH_SOURCE[0]}")
    array=$(sbatch --parsable --job-name=drystone --array=1-"$shards" --requeue \
        --open-mode=append --nodes=1 --ntasks=1 --cpus-per-task=@threads@ --time=@minutes@ \
        --signal=B:USR1@60 --output="$logs/%a.log" "$@" "$script")
    merge=$(sbatch --parsable --job-name=drystone-merge --dependency=afterany:"$array" \
        --requeue --open-mode=append --ntasks=1 --output="$logs/merge.log" "$@" "$script" merge)
    echo "array $array, merge $merge; logs in $logs"
    exit 0
fi

shard() { # $1: number; the name of its file
    if ((shards == 1)); then echo "$out"; return; fi
    printf '%s_%0*d_of_%s.h5' "${out%.h5}" "${#shards}" "$1" "$shards"
}

if [[ ${1-} == merge ]]; then
    files=()
    for ((i = 1; i <= shards; ++i)); do files+=("$(shard "$i")"); done
    ((shards == 1)) || "$program" merge "$out" "${files[@]}"
    exit
fi

# A minute before its time is over the program is told to end, and the task asks for another turn.
child=0
trap '((child == 0)) || kill -TERM "$child"' USR1
"$program" study "$study" --out "$out" --shard "$SLURM_ARRAY_TASK_ID/$shards" \
    --threads "${SLURM_CPUS_PER_TASK:-1}" --quiet@options@ &
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
// clang-format on

/// As one word of a shell.
std::string quoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

/// Twice the expected time and a quarter of an hour, at least one hour.
int limit_minutes(double expected)
{
    return static_cast<int>(std::ceil(std::max(60.0, 2.0 * expected + 15.0)));
}

std::string options_of(const ShardScript& s)
{
    std::string text;
    for (const std::string& o : s.overrides) text += " --set " + quoted(o);
    return text;
}

} // namespace

int shard_count(std::size_t walls, double seconds, int threads)
{
    const double n = static_cast<double>(walls);
    const double wanted = std::ceil(n * seconds / (kShardSeconds * threads));
    return static_cast<int>(std::clamp(wanted, 1.0, std::min(kMostShards, std::max(1.0, n))));
}

std::string slurm_script(const ShardScript& s)
{
    std::string text = kScript;
    const std::pair<std::string_view, std::string> values[] = {
        {"@program@", quoted(s.program)},
        {"@study@", quoted(s.study)},
        {"@out@", quoted(s.out)},
        {"@logs@", quoted(s.folder)},
        {"@shards@", std::to_string(s.shards)},
        {"@threads@", std::to_string(s.threads)},
        {"@minutes@", std::to_string(limit_minutes(s.minutes))},
        {"@options@", options_of(s)}};
    for (const auto& [name, value] : values) // each stands once
        text.replace(text.find(name), name.size(), value);
    return text;
}

} // namespace app
