#!/usr/bin/env bash
# bash bench/speed.sh [OUT.md]   times of whole commands on this machine, today: shortest of DRYSTONE_RUNS runs (default 3)
#
# OUT.md: default docs/bench/speed/speed.md. The machine should be idle; the load at the beginning is written down.
# DRYSTONE_PROGRAM: the program (default: what ./drystone builds).
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
out=$(realpath -m -- "${1:-docs/bench/speed/speed.md}")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
drystone() { ./drystone "$@"; }
drystone version >/dev/null # and with it the build
load=$(cut -d' ' -f1 /proc/loadavg)
TIMEFORMAT='%R %U %S'

processor() { # "AMD EPYC (family 25, model 17)"
    awk -F '[ \t]*: ' '$1 == "model name" {name = $2} $1 == "cpu family" {family = $2} $1 == "model" {model = $2}
        END {printf "%s (family %s, model %s)", name, family, model}' /proc/cpuinfo
}

row() { # $1: what; then the arguments of ./drystone; FILE stands for a new file
    local what=$1 run times=() shown
    shift
    shown="./drystone ${*//FILE.h5/runs/x.h5}"
    for ((run = 0; run < ${DRYSTONE_RUNS:-3}; ++run)); do
        rm -f -- "$work"/new.h5
        times+=("$({ time drystone "${@//FILE.h5/$work/new.h5}" >"$work/log" 2>&1 </dev/null; } 2>&1)") || {
            tail -n 20 -- "$work/log" >&2
            return 1
        }
    done
    printf '%s\n' "${times[@]}" | sort -n | head -n 1 |
        awk -v what="$what" -v shown="${shown//"$work"/runs}" '{printf "| %s | %.1f | %.1f | `%s` |\n", what, $1, $2 + $3, shown}'
}

{
    echo "# Whole commands"
    echo
    echo "Written by \`bash bench/speed.sh\` on $(LC_ALL=C date -u '+%-d %B %Y') on $(processor), $(nproc) cores;"
    echo "$(drystone version | head -n 1); load before: $load. Shortest of ${DRYSTONE_RUNS:-3} run(s); core s: of all cores together."
    echo
    echo "| what | seconds | core s | command |"
    echo "|---|---:|---:|---|"
    row "one wall, pushed by 30 mm, with its pictures and its series" push configs/wall.ini --out "$work/wall"
    row "five walls" push configs/levels.ini --out "$work/levels"
    row "a wall from a drawing" push configs/drawing.ini --out "$work/drawing"
    row "rubble in mortar from a picture" push configs/picture.ini --out "$work/picture"
    row "48 random walls" study configs/quick.ini --out FILE.h5
    row "the paper's 250 random walls, its damping" study configs/paper.ini --out FILE.h5
    row "the same, default damping" study configs/paper.ini --set solver.damping=combined --out FILE.h5
    row "its 100 walls of random joints" study configs/paper_spatial.ini --out FILE.h5
    drystone study configs/paper.ini --out "$work/paper.h5" >/dev/null 2>&1
    row "all tables of the 250 walls" fragility "$work/paper.h5" --out "$work/tables"
    row "their page" report "$work/paper.h5" --out "$work/page.html"
} >"$work/speed.md"
mkdir -p -- "$(dirname -- "$out")"
cp -- "$work/speed.md" "$out"
