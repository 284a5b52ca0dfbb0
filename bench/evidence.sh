#!/usr/bin/env bash
# bash bench/evidence.sh   writes docs/calibration/evidence.md and .csv: the evidence of laws for joints and cracks, by the seven tests of
# configs/lourenco2005.csv. Walls that were pushed are kept in runs/evidence and taken again.
# An accuracy of 3 % for all of them: it moves mean drops by 3 to 6 % (docs/validation.md, section 5), and walls whose joints close cost a third.
# DRYSTONE_PROGRAM: the program.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
drystone=${DRYSTONE_PROGRAM:-build/release/app/drystone}
closing=(--set joint.closure=exponential --set "joint.wall_modulus_stress=0.15, 0.50, 1.00, 1.25 MPa")
hyperbolic=(--set unit.envelope=hyperbolic --set "unit.shear_fracture_energy=1100 N/m")

calibrate() { # $1: name; further arguments: what differs from configs/calibration.ini
    local name=$1
    shift
    "$drystone" calibrate configs/calibration.ini configs/lourenco2005.csv --quiet --out "runs/evidence/$name" --set "solver.accuracy=3 %" "$@" \
        >"runs/evidence/$name.txt"
}
mkdir -p runs/evidence
calibrate linear_coulomb
calibrate closing_coulomb "${closing[@]}"
calibrate linear_hyperbolic "${hyperbolic[@]}"
calibrate closing_hyperbolic "${closing[@]}" "${hyperbolic[@]}"
python3 bench/evidence.py runs/evidence docs/calibration/evidence
