#!/usr/bin/env bash
# bash bench/default_push.sh [WORK [WALLS]]   what a push to the limits costs and gives beside one with small displacements to
# 30 mm: configs/paper.ini and the same walls by the defaults of a study. Writes docs/bench/accuracy/default_push.md.
# WORK (default runs/default_push) keeps the studies of WALLS (50) walls under each stress. DRYSTONE_PROGRAM and DRYSTONE_BENCH: the program and the folder of the benchmarks.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/default_push} walls=${2:-50}
program=${DRYSTONE_PROGRAM:-build/release/app/drystone} bench=${DRYSTONE_BENCH:-build/release/bench}
mkdir -p -- "$work"

study() { # $1: study; $2: name
    "$program" study "$1" --out "$work/$2.h5" --set output.curves=single --set uq.samples="$walls" --set solver.fidelity=simple \
        --set solver.damping=combined --set fragility.modes=mechanism >"$work/$2.txt" 2>&1 ||
        echo "$2: not all walls gave a result" >&2
}
study configs/paper.ini small
sed '/^max_displacement\|^kinematics/d' configs/paper.ini >"$work/default.ini" # the keys that the paper's file gives
study "$work/default.ini" default
"$bench/default_push" "$work" docs/bench/accuracy/default_push.md
