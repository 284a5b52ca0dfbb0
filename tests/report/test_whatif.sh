#!/usr/bin/env bash
# test_whatif.sh DRYSTONE FOLDER   what a page's sliders say is what the file of `drystone surrogate` says, served over HTTP
# Exit 77: node is missing.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
drystone=$1 folder=$2
command -v node >/dev/null || { echo "node is missing"; exit 77; }

rm -rf -- "$folder"
mkdir -p -- "$folder"
"$drystone" study "$here/../study/small.ini" --out "$folder/asked.h5" --quiet --set uq.samples=52 --set load.max_displacement="15 mm" \
    --set joint.friction_angle="beta(mean 31.8 deg, cov 0.2, lower 15 deg, upper 50 deg)" --set unit.tensile_strength="gamma(mean 3.7 MPa, cov 0.3)" >"$folder/asked.txt"
"$drystone" report "$folder/asked.h5" --out "$folder/asked.html" --walls 0 --quiet
for response in peak_force ultimate_drift; do
    "$drystone" surrogate "$folder/asked.h5" --of "$response" --out "$folder/$response" --quiet >"$folder/$response.txt"
done
exec node "$here/test_whatif.mjs" "$drystone" "$folder"
