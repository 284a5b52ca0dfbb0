#!/usr/bin/env bash
# test_page.sh pages DRYSTONE FOLDER      writes a small study and its pages
# test_page.sh claim FOLDER CLAIM...      one claim of test_page.mjs about them
# Exit 77: chromium or node is missing.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
    echo "chromium is missing"
    exit 77
}
command -v node >/dev/null || { echo "node is missing"; exit 77; }

if [[ $1 == pages ]]; then
    drystone=$2 folder=$3
    rm -rf -- "$folder"
    mkdir -p -- "$folder"
    small=$here/../study/small.ini
    # page NAME [options of study]: failing=1 where walls are to fail, and study to exit with 1
    page() {
        local name=$1 code=0
        shift
        "$drystone" study "$folder/study.ini" --out "$folder/$name.h5" --quiet "$@" >"$folder/$name.txt" || code=$?
        [[ $code == "${failing-0}" ]]
        "$drystone" report "$folder/$name.h5" --out "$folder/$name.html" --quiet
    }
    cp -- "$small" "$folder/study.ini"
    page small --set uq.samples=12
    "$drystone" report "$folder/small.h5" --out "$folder/few.html" --walls 3 --quiet
    page one_stress --set uq.samples=6 --set load.vertical_stress="0.5 MPa" --set joint.wall_modulus="768 MPa"
    page three_stresses --set uq.samples=2 --set load.vertical_stress="0.5, 0.75, 1 MPa" --set joint.wall_modulus="768, 900, 1057 MPa"
    page nothing_random --set uq.samples=1 --set joint.friction_angle="31.8 deg" \
        --set joint.stiffness_factor=1 --set unit.tensile_strength="3.7 MPa"
    page spatial --set uq.samples=4 --set uq.spatial=independent
    page crushing --set uq.samples=2 --set joint.compressive_strength="8 MPa" --set joint.crushing_energy="5000 N/m"
    failing=1 page some_failed --set uq.samples=12 --set solver.most_steps=5000
    failing=1 page all_failed --set uq.samples=3 --set solver.most_steps=500
    page many --set uq.samples=2200 --set load.max_displacement="0.5 mm"
    page asked --set uq.samples=40 --set load.max_displacement="15 mm"
    page piers --set uq.samples=4 --set wall.openings="0.1 m, 0 m, 0.2 m, 0.2 m" --set lintel.bearing="0.1 m" \
        --set load.direction=both --set fragility.limit_states="paper, ntc"
    page layouts --set uq.samples=6 --set wall.bond=rubble --set wall.layouts=4
    "$drystone" study "$small" --out "$folder/part.h5" --quiet --set uq.samples=8 --shard 1/3 >"$folder/part.txt"
    "$drystone" report "$folder/part_1_of_3.h5" --out "$folder/shard.html" --quiet
    sed 's/^max_displacement.*/targets = 2, -2, 3, -3, 0 mm/' "$small" >"$folder/study.ini"
    page cyclic --set uq.samples=3
else
    folder=$2
    shift 2
    exec node "$here/test_page.mjs" "$chromium" "$folder" "$*"
fi
