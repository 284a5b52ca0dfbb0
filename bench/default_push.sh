#!/usr/bin/env bash
# bash bench/default_push.sh [WORK]   what a push to the limits costs and gives beside one with small displacements to
# 30 mm: configs/paper.ini and the same walls by the defaults of a study. Writes docs/bench/default_push.md.
# WORK (default runs/default_push) keeps the studies. DRYSTONE_PROGRAM and DRYSTONE_BENCH: the program and the folder of the benchmarks.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/default_push}
program=${DRYSTONE_PROGRAM:-build/release/app/drystone} bench=${DRYSTONE_BENCH:-build/release/bench}
mkdir -p -- "$work"

study() { # $1: name; then options
    "$program" study configs/paper.ini --out "$work/$1.h5" --set output.curves=single \
        --set solver.fidelity=simple --set solver.damping=combined --set fragility.modes=mechanism "${@:2}" >"$work/$1.txt" 2>&1 ||
        echo "$1: not all walls gave a result" >&2
}
study small
sed '/^max_displacement\|^kinematics/d' configs/paper.ini >"$work/default.ini" # the keys that the paper's file gives
"$program" study "$work/default.ini" --out "$work/default.h5" --set output.curves=single \
    --set solver.fidelity=simple --set solver.damping=combined --set fragility.modes=mechanism >"$work/default.txt" 2>&1 ||
    echo "default: not all walls gave a result" >&2
"$bench/default_push" "$work" docs/bench/default_push.md
