#!/usr/bin/env bash
# test_cookbook.sh PROGRAM PAGE   runs every `./drystone` line of a page, in order, in a folder of its own; walls are made
# cheap, samples few. Fenced parts whose first line has a name (```csv drifts.csv) are files of that folder.
# Exit code 0: all ran, 1: one did not.
set -euo pipefail

program=$(readlink -f -- "$1") page=$(readlink -f -- "$2")
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cp -r -- "$root/configs" "$work"
cd -- "$work"

# Files and commands of the page.
awk '/^```/ { if (open) { open = 0; file = "" } else { open = 1; file = $2 } ; next }
     open && file != "" { print > file }
     open && file == "" && /^\.\/drystone / { print > "commands" }' "$page"
[[ -s commands ]] || { echo "no command in $page" >&2; exit 1; }

add() { # $1: key=value, unless the line has that key
    [[ $line == *"${1%%=*}="* ]] || line+=" --set \"$1\""
}

cheap() { # of $line
    line=${line%%  #*}
    # a tenth of the samples; wall 1 in place of wall 17; shorter records; fewer starts of another program
    line=$(sed -E 's/(samples=[0-9]+)0\b/\1/; s/--sample ([0-9])[0-9]+/--sample \1/; s/duration 2 s/duration 0.5 s/; s/budget=400/budget=100/' <<<"$line")
    [[ $line != *" reliability program.ini"* ]] || add reliability.budget=300
    [[ $line =~ \./drystone\ (push|study|sample|reliability|sheet|choices|calibrate)\ (configs/|house\.ini) ]] || return 0
    add solver.fidelity=rigid
    add solver.steps_per_mm=100
    add "load.max_displacement=3 mm"
    add "solver.accuracy=20 %"
    case $line in
        *" calibrate "*) add uq.samples=10 && add "calibration.inputs=joint.friction_angle, unit.friction_angle" ;;
        *" study "* | *" sample "*) add uq.samples=8 && add uq.most_samples=60 ;;
        *" reliability "*) line=${line/fidelity=rigid/fidelity=simple} && add reliability.cheap=rigid && add reliability.budget=60 ;;
    esac
}

ran=0
while IFS= read -r line; do
    [[ $line != "./drystone test"* ]] || continue
    cheap
    printf '%s\n' "$line"
    code=0
    DRYSTONE=$program PATH=/usr/bin:$PATH bash -c "${line/.\/drystone/\"\$DRYSTONE\"}" >said 2>&1 </dev/null || code=$?
    ! grep -q 'built without the libraries' said || { echo "not run, no OpenCV: $line"; continue; }
    ((code == 0)) || { cat said >&2; echo "exit code $code" >&2; exit 1; }
    ran=$((ran + 1))
done <commands
echo "$ran commands of $(basename -- "$page")"

for script in *.py; do # what reads the files; needs h5py
    [[ -f $script && $script != model.py ]] || continue
    /usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "not run, no h5py: $script"; continue; }
    /usr/bin/python3 "$script" || exit 1
done
