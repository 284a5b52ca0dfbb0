#!/usr/bin/env bash
# ./drystone cyclic [WORK]   runs all walls behind docs/cyclic.md and writes it anew
#
# WORK (default runs/cyclic) keeps the files of the studies, so that a second run only does what is missing.
# DRYSTONE_SAMPLES: walls under each stress (default 50).
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/cyclic}
mkdir -p -- "$work"

study() { # $1: file; then key=value
    local file=$work/$1.h5 set=() override
    for override in "solver.damping=combined" "uq.samples=${DRYSTONE_SAMPLES:-50}" "${@:2}"; do
        set+=(--set "$override")
    done
    "$DRYSTONE_PROGRAM" study configs/paper.ini --out "$file" "${set[@]}" >/dev/null
}

study one_way
study cyclic load.amplitudes="3, 6, 10, 15, 20, 30 mm"
"$DRYSTONE_BENCH/cyclic" "$work" docs
