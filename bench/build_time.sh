#!/usr/bin/env bash
# bash bench/build_time.sh [PRESET]   what a first build takes, part by part, in a fresh clone: wall time and the
# time of all cores together, in seconds. Packages are timed where some are missing. The clone is removed.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
preset=${1:-release}
clone=$(mktemp -d)
trap 'rm -rf -- "$clone"' EXIT
# what caches would hide
unset CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER LDFLAGS CXXFLAGS CFLAGS
TIMEFORMAT='%R %U %S'

part() { # $1: name; then the command
    local name=$1 times
    shift
    times=$({ time "$@" >"$clone/log" 2>&1 </dev/null; } 2>&1) || {
        tail -n 20 -- "$clone/log" >&2
        return 1
    }
    awk -v name="$name" '{printf "| %s | %.0f | %.0f |\n", name, $1, $2 + $3}' <<<"$times"
}
target() { ninja -C "$clone/drystone/build/$preset" -j "$(nproc)" "$@"; }

grep -m1 '^model name' /proc/cpuinfo | cut -d: -f2-
echo "$(nproc) cores, preset $preset, load $(cut -d' ' -f1 /proc/loadavg)"
echo "| part | wall time [s] | cores' time [s] |"
echo "|---|---|---|"
git clone -q -- "$root" "$clone/drystone"
cd -- "$clone/drystone"
mapfile -t packages < <(sed -n '/^packages=(/,/)/p' drystone | tr -d '()' | sed 's/packages=//' | xargs -n 1)
dpkg-query -W "${packages[@]}" >/dev/null 2>&1 ||
    part "packages" sh -c 'apt-get -qq update && apt-get -qq install -y --no-install-recommends "$@"' sh "${packages[@]}"
part "configure" cmake --preset "$preset" -D CMAKE_UNITY_BUILD=ON
part "dem" target drystone_dem
part "uq" target drystone_uq_sampling drystone_uq_analysis drystone_uq_reliability
part "fragility" target drystone_fragility
part "app and link" target drystone
part "the first push" "build/$preset/app/drystone" push configs/wall.ini --quiet --out "$clone/wall"
part "tests, built" target all
part "tests, run" ctest --test-dir "build/$preset" -j "$(nproc)" --timeout 900
