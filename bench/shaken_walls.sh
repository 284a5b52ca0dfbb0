#!/usr/bin/env bash
# bash bench/shaken_walls.sh [WORK]   runs the studies behind the five-stress table of docs/dynamics.md and writes it anew
#
# The walls of configs/shaken_study.ini: shaken, pushed one way and pushed to and fro. WORK (default runs/shaken_walls) keeps the
# files of the studies, so that a second run only does what is missing.
# DRYSTONE_PROGRAM: the program (default ./drystone). DRYSTONE_SAMPLES: walls under each stress (default that of the study).
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/shaken_walls}
program=${DRYSTONE_PROGRAM:-./drystone}
set=()
if [[ -n ${DRYSTONE_SAMPLES:-} ]]; then set=(--set "uq.samples=$DRYSTONE_SAMPLES"); fi
mkdir -p -- "$work"

run() { # a study with failed walls has its tables all the same
    "$program" "$@" --quiet >/dev/null 2>>"$work/remarks.txt" || echo "$*: not all walls gave a result" >&2
}

run study configs/shaken_study.ini --out "$work/shaken.h5" "${set[@]}"
for measure in pga pgv "sa(0.3 s)"; do
    run fragility "$work/shaken.h5" --intensity "$measure" --out "$work/${measure%%(*}"
done

# The same walls pushed: the study without what is about shaking.
awk '/^\[/ { shaking = ($0 == "[shaking]") } !shaking && !/^(mass|shaken_)/' configs/shaken_study.ini >"$work/pushed.ini"
run study "$work/pushed.ini" --out "$work/one_way.h5" "${set[@]}"
run study "$work/pushed.ini" --out "$work/cyclic.h5" "${set[@]}" --set load.amplitudes="3, 6, 10, 15, 20, 30 mm"
for way in one_way cyclic; do run fragility "$work/$way.h5" --out "$work/$way"; done
python3 bench/shaken_walls.py "$work" docs/dynamics.md
