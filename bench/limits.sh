#!/usr/bin/env bash
# bash bench/limits.sh [WORK]   runs the studies behind docs/limits.md and writes it anew
#
# The walls of configs/collapse.ini, 50 under each stress (16 under two of them for the density of cracks),
# changed in one thing at a time. The accuracy is 3 %, since the scatter of the walls is much more; one row has 1 %.
# WORK (default runs/limits) keeps the files of the studies, so that a second run only does what is missing.
# DRYSTONE_PROGRAM and DRYSTONE_BENCH: the program and the folder of the benchmarks.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/limits}
program=${DRYSTONE_PROGRAM:-build/release/app/drystone} bench=${DRYSTONE_BENCH:-build/release/bench}
mkdir -p -- "$work"

push() { # $1: name; then key=value
    local set=() override
    for override in uq.samples="${samples:-50}" output.curves=single solver.accuracy="${accuracy:-3 %}" "${@:2}"; do set+=(--set "$override"); done
    "$program" study configs/collapse.ini --out "$work/$1.h5" "${set[@]}" >"$work/$1.txt" 2>&1 ||
        echo "$1: not all walls gave a result" >&2 # the tables count those that failed, and refuse missing ones
}

study() { push "$@" load.stop_below=0.8; }

push small solver.kinematics=small load.max_displacement="30 mm"
study finite
accuracy="1 %" study accurate
study fixed_line load.top=fixed_line
study follower load.top=follower
study strut load.top=link load.link_length="2 m"
study tendon load.top=link load.link_length="-1.1 m"
study double beam.rotation=fixed
study standard solver.fidelity=standard
crushing="joint.crushing_energy=25000 N/m"
study crushing_92 joint.compressive_strength="92 MPa" "$crushing"
study crushing_57 joint.compressive_strength="57 MPa" "$crushing"
study crushing_57_brittle joint.compressive_strength="57 MPa" joint.crushing_energy="5000 N/m"
study crushing_20 joint.compressive_strength="20 MPa" "$crushing"
study cracks_2x2 solver.fidelity=standard unit.cracks="grid(2, 2)" unit.cracks_where=toe
study cracks_2x2_crushing_57 solver.fidelity=standard unit.cracks="grid(2, 2)" unit.cracks_where=toe joint.compressive_strength="57 MPa" "$crushing"

# Density of cracks.
samples=16
dense() { study "dense_$1" solver.fidelity=standard load.vertical_stress="0.75, 1.25 MPa" joint.wall_modulus="912.5, 1202 MPa" "${@:2}"; }
dense mid
dense thirds unit.cracks=thirds
dense 2x2 unit.cracks="grid(2, 2)" unit.cracks_where=toe
dense 4x4 unit.cracks="grid(4, 4)" unit.cracks_where=toe
dense voronoi_100 unit.cracks="voronoi(100 mm)" unit.cracks_where=toe
dense voronoi_66 unit.cracks="voronoi(66 mm)" unit.cracks_where=toe
dense voronoi_50 unit.cracks="voronoi(50 mm)" unit.cracks_where=toe
dense 2x2_all unit.cracks="grid(2, 2)"
dense 2x2_needed unit.cracks="grid(2, 2)" unit.cracks_where=needed

"$bench/limits" "$work" docs/limits.md
