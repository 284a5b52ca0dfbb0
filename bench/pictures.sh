#!/usr/bin/env bash
# bash bench/pictures.sh [WORK]   makes the pictures of README and docs/pictures anew (but for top_load.svg, which is drawn)
#
# WORK (default runs/pictures) keeps the pushes and the study behind them. DRYSTONE_PROGRAM: the program (default: ./drystone).
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
work=${1:-runs/pictures} to=docs/pictures
push() { # $1: study; $2: name; then options
    "${DRYSTONE_PROGRAM:-./drystone}" push "configs/$1.ini" --out "$work/$2" --quiet "${@:3}" >/dev/null
}

push levels levels
for stress in 0.15 0.50 1.00 1.25; do cp -- "$work/levels/${stress}_MPa/wall.svg" "$to/wall_$stress.svg"; done
push wall film --film --set load.vertical_stress="1.25 MPa" --set joint.wall_modulus="1202 MPa"
cp -- "$work/film/film.svg" "$to/film.svg"
push picture picture
cp -- "$work/picture/wall.svg" "$to/rubble.svg"
push facade facade
cp -- "$work/facade/wall.svg" "$to/facade.svg"
push wall cycles --set load.amplitudes="1, 5, 10 mm"
cp -- "$work/cycles/capacity.svg" "$to/cycles.svg"
"${DRYSTONE_PROGRAM:-./drystone}" study configs/quick.ini --out "$work/quick.h5" --quiet >/dev/null
"${DRYSTONE_PROGRAM:-./drystone}" fragility "$work/quick.h5" --out "$work/quick" --quiet >/dev/null
cp -- "$work/quick/pictures/curve_ntc_SLD.svg" "$to/fragility.svg"
"${DRYSTONE_PROGRAM:-./drystone}" scene configs/wall.ini --out "$work/scene" >/dev/null
cp -- "$work/scene/laws.svg" "$to/laws.svg"
