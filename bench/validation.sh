#!/usr/bin/env bash
# ./drystone validate [--end] [WORK]   runs all walls behind docs/validation.md and writes it anew
#
# --end: those of its last section, walls pushed until no force is left, and only that section.
# 40 min on two cores of an AMD EPYC with AVX-512. WORK (default runs/validation) keeps the files of the
# studies, so that a second run only does what is missing. DRYSTONE_TEST_CURVES, the folder of the measured
# curves (bench/tested/measured_walls.hpp), if given: docs/tests is written anew too.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
end=()
if [[ ${1-} == --end ]]; then
    end=(--end)
    shift
fi
work=${1:-runs/validation}
mkdir -p -- "$work/effects"

study() { # $1: file; $2: configuration; then key=value
    local file=$work/$1.h5 config=$2 set=() override
    for override in "${@:3}"; do set+=(--set "$override"); done
    "$DRYSTONE_PROGRAM" study "$config" --out "$file" "${set[@]}" >/dev/null
}

effect() { # $1: name; then key=value: five stress levels, the same 50 samples each
    study "effects/$1" configs/paper.ini "${@:2}"
}

# What the paper did, and the same with ten times the walls.
study paper configs/paper.ini
study collapse configs/collapse.ini
if ((${#end[@]})); then
    exec "$DRYSTONE_BENCH/validation" "$work" docs "${end[@]}"
fi
study spatial configs/paper_spatial.ini
study large configs/paper.ini uq.samples=500
study large_combined configs/paper.ini uq.samples=500 solver.damping=combined
study spatial_large configs/paper_spatial.ini uq.samples=500
study spatial_independent configs/paper_spatial.ini uq.samples=500 uq.spatial=independent

# Values per joint, one input at a time, the others at their means.
mkdir -p -- "$work/joint"
means=("joint.friction_angle=31.8 deg" "joint.stiffness_factor=1" "unit.tensile_strength=3.7 MPa"
    "unit.friction_angle=35 deg" "unit.stiffness_factor=1")
per_joint() { # $1: file; $2: the key that stays random; then key=value
    local mean set=()
    for mean in "${means[@]}"; do [[ ${mean%%=*} == "$2" ]] || set+=("$mean"); done
    study "joint/$1" configs/paper_spatial.ini "${set[@]}" "${@:3}"
}
per_joint none none uq.samples=1
per_joint joint_friction joint.friction_angle
per_joint joint_stiffness joint.stiffness_factor
per_joint unit_strength unit.tensile_strength
per_joint unit_friction unit.friction_angle
per_joint unit_stiffness unit.stiffness_factor
study joint/more_scatter configs/paper_spatial.ini joint.friction_angle="normal(mean 31.8 deg, cov 0.30)"
study joint/by_course configs/paper_spatial.ini uq.spatial=correlated uq.kernel=same_course uq.group_correlation=1

# As much as this geometry can carry under the lowest stress: rigid blocks on joints that hardly give.
study rigid_limit configs/paper.ini load.vertical_stress="0.15 MPa" joint.wall_modulus="566 MPa" \
    joint.stiffness_factor="normal(mean 30, cov 0.25)" solver.fidelity=rigid \
    solver.damping=combined uq.samples=500

# What the paper leaves open, one at a time.
effect load_height_1.05 load.height="1.05 m"
effect load_height_1.15 beam.height="0.20 m" beam.density="3750 kg/m3" load.height="1.15 m"
effect beam_0.20 beam.height="0.20 m" beam.density="3750 kg/m3" load.height="1.10 m"
effect base_joint wall.base=joint
effect first_course_fixed wall.courses=9 wall.first_course=shifted wall.base=joint wall.toe=free load.height="1.00 m"
effect toe_free wall.toe=free
effect beam_joint beam.interface=joint
effect beam_light beam.density="2400 kg/m3"
effect density_2000 stone.density="2000 kg/m3"
effect density_2600 stone.density="2600 kg/m3"
effect points_4 solver.contact_points=4
effect points_7 solver.contact_points=7
effect modes_6 solver.block_modes=6
effect modes_all solver.fidelity=zones
effect even_points solver.face_rule=even
effect snap_back_weakens unit.snap_back=weakens
effect unloading_elastic unit.unloading=elastic
effect uncoupled unit.contact_law=uncoupled
effect strength_in_tension unit.tension_reduces_shear=no
effect damping_0.5 solver.damping_factor=0.5
effect damping_0.95 solver.damping_factor=0.95
effect combined solver.damping=combined
effect combined_0.95 solver.damping=combined solver.damping_factor=0.95
effect drive_fast solver.accuracy="3 %"
effect drive_slow solver.accuracy="0.3 %"
effect drive_constant_fast solver.steps_per_mm=300 solver.unbalance_limit=0
effect drive_constant_slow solver.steps_per_mm=3000 solver.unbalance_limit=0
effect modulus_768 joint.wall_modulus="566, 768, 768, 1057, 1202 MPa"
effect modulus_1057 joint.wall_modulus="566, 768, 1057, 1057, 1202 MPa"
effect push_28 load.max_displacement="28 mm"
effect push_45 load.max_displacement="45 mm"

# One wall each, mean values: Figures 6 and 7.
if [[ -n ${DRYSTONE_TEST_CURVES-} ]]; then
    "$DRYSTONE_PROGRAM" push configs/levels.ini --out "$work/levels" >/dev/null
    "$DRYSTONE_PROGRAM" push configs/uncoupled.ini --out "$work/uncoupled" >/dev/null
    "$DRYSTONE_BENCH/compare_tests" "$work/levels" "$DRYSTONE_TEST_CURVES" docs/tests "$work/uncoupled"
fi

"$DRYSTONE_BENCH/validation" "$work" docs
