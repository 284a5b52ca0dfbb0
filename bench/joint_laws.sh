#!/usr/bin/env bash
# ./drystone joint_laws [WORK]   runs all walls behind docs/joint_laws.md and writes it anew
#
# About three hours on two cores. WORK (default runs/joint_laws) keeps the files of the studies, so that a second run only
# does what is missing.
# DRYSTONE_SAMPLES: walls under each stress (default 50), DRYSTONE_CHECKED_SAMPLES: walls under each stress that are run again more
# slowly and on a finer wall (default 10). DRYSTONE_TEST_CURVES: the folder of the measured curves (bench/tested/measured_walls.hpp), if
# given; else the page has the tests' numbers that bench/joint_laws/tested_walls.cpp keeps.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/joint_laws}
mkdir -p -- "$work"/{random,checked,mean,choice,cycles}

study() { # $1: file; then key=value
    local file=$work/$1.h5 set=() override
    for override in "${@:2}"; do set+=(--set "$override"); done
    "$DRYSTONE_PROGRAM" study configs/closure.ini --out "$file" "${set[@]}" >/dev/null
}

linear=(joint.closure=linear "joint.wall_modulus=566, 768, 912.5, 1057, 1202 MPa")
coulomb=(unit.envelope=coulomb)
brittle=(unit.shear_fracture_energy=none)
hyperbolic=(joint.closure=hyperbolic)
means=(uq.samples=1 "joint.friction_angle=31.8 deg" joint.stiffness_factor=1 "unit.tensile_strength=3.7 MPa"
    "unit.friction_angle=35 deg" unit.stiffness_factor=1)

# $1: folder; $2: law, and behind a colon the name of the file; then key=value
law() {
    local keys=()
    case ${2%%:*} in
    paper) keys=("${linear[@]}" "${coulomb[@]}" "${brittle[@]}") ;;
    hyperbolic_closure) keys=("${hyperbolic[@]}" "${coulomb[@]}" "${brittle[@]}") ;;
    exponential_closure) keys=("${coulomb[@]}" "${brittle[@]}") ;;
    envelope) keys=("${linear[@]}" "${brittle[@]}") ;;
    shear_energy) keys=("${linear[@]}" "${coulomb[@]}") ;;
    all_hyperbolic) keys=("${hyperbolic[@]}") ;;
    all_exponential) ;;
    esac
    study "$1/${2#*:}" "${keys[@]}" "${@:3}"
}

laws=(paper all_hyperbolic envelope shear_energy all_exponential exponential_closure hyperbolic_closure)

# Each change alone and all together on random walls. Simply deformable blocks and an accuracy of 3 %: their scatter is much more.
cheap=(solver.fidelity=simple "solver.accuracy=3 %")
for name in "${laws[@]}"; do
    law random "$name" "uq.samples=${DRYSTONE_SAMPLES:-50}" "${cheap[@]}"
done

# The wall with mean values.
for name in "${laws[@]}"; do
    law mean "$name" "${means[@]}"
done

# The same at another speed and on a finer wall; two laws more slowly too.
fast=("solver.accuracy=3 %")
finer=("solver.accuracy=3 %" solver.fidelity=fine)
for name in "${laws[@]}"; do
    law mean "$name:${name}_fast" "${means[@]}" "${fast[@]}"
    law mean "$name:${name}_fine" "${means[@]}" "${finer[@]}"
done
for name in paper all_hyperbolic; do
    law mean "$name:${name}_slow" "${means[@]}" "solver.accuracy=0.3 %"
done

# The free choices of closure, each at two speeds and on two walls.
choice() { # $1: name of the file; then key=value
    local with=("${means[@]}" "load.vertical_stress=0.50, 1.00, 1.25 MPa" "${@:2}")
    law choice "all_hyperbolic:$1" "${with[@]}"
    law choice "all_hyperbolic:$1_fast" "${with[@]}" "${fast[@]}"
    law choice "all_hyperbolic:$1_fine" "${with[@]}" "${finer[@]}"
}
for limit in 60 120 240 1000; do
    choice limit_$limit "joint.largest_stiffness=$limit GPa/m"
done
for loss in 0.1 0.3; do
    choice loss_$loss joint.closure_loss=$loss
done

# Cycles of a wall that rocks.
cycles() { # $1: what the names of the files end with; then key=value
    local rocks=(wall.courses=12 "load.height=1.30 m" wall.unit_cracks=no "load.vertical_stress=0.50 MPa" load.stop_below=0
        "load.amplitudes=3, 6, 10, 15, 20, 30 mm" "${means[@]}" "${@:2}") loss
    study "cycles/paper$1" "${coulomb[@]}" "${brittle[@]}" joint.closure=linear "joint.wall_modulus=768 MPa" "${rocks[@]}"
    for loss in 0 0.1 0.3; do
        law cycles "all_hyperbolic:loss_$loss$1" "${rocks[@]}" joint.closure_loss=$loss
    done
}
cycles "" "${fast[@]}"
cycles _slow "solver.accuracy=1 %"
cycles _fine "${finer[@]}"

# Two speeds and two discretisations of random walls.
some="uq.samples=${DRYSTONE_CHECKED_SAMPLES:-10}"
for name in "${laws[@]}"; do
    law checked "$name" "$some" "${cheap[@]}"
    law checked "$name:${name}_slow" "$some" solver.fidelity=simple "solver.accuracy=1 %"
    law checked "$name:${name}_fine" "$some" solver.fidelity=standard "solver.accuracy=3 %"
done

"$DRYSTONE_BENCH/joint_laws" "$work" docs
