#!/usr/bin/env bash
# bash tests/golden.sh PROGRAM [FOLDER]            runs the cases below and compares every output with tests/golden.txt
# bash tests/golden.sh --accept PROGRAM [FOLDER]   writes tests/golden.txt anew: in a commit that says why each line moved
#
# The outputs stay in FOLDER (default: build/golden), freed of times, versions and machine: the same for every build,
# register width and number of threads. `diff -r` of the folders of two programs shows what moved between them.
# curve_hash is taken from the build directory of PROGRAM; without it, or without h5dump (hdf5-tools), its lines are left out.
set -euo pipefail
export LC_ALL=C
unset COLUMNS

self=$(readlink -f -- "${BASH_SOURCE[0]}")
root=${self%/tests/*}
list=$root/tests/golden.txt

die() {
    printf 'golden.sh: %s\n' "$*" >&2
    exit 2
}

run() { # $1: verb; then its arguments. Adds what it says to `said` of the case
    local code=0
    {
        printf '$ drystone'
        printf ' %q' "$@"
        printf '\n'
    } >>said
    "$program" "$@" </dev/null >>said 2>stderr || code=$?
    cat -- stderr >>said
    rm -- stderr
    printf 'exit code %d\n' "$code" >>said
}

push() { # $1: study; then options
    run push "../configs/$1.ini" --out . --quiet --threads 2 "${@:2}"
}

study() { # $1: study; then options. Its file, tables and page
    run study "../configs/$1.ini" --out study.h5 --report --quiet --threads 2 "${@:2}"
}

simple=(--set solver.fidelity=simple)

# The cases, the slowest first.
case_study_paper() { study paper --set uq.samples=8 "${simple[@]}"; }
case_study_quick() { study quick && run curves study.h5 --quiet; }
case_push_collapse() { push collapse --sample mean --level '0.5 MPa'; }
case_reliability() { run reliability ../configs/reliability.ini --out . --quiet --threads 2 --set reliability.method=multi_fidelity --set reliability.budget=40 "${simple[@]}" --set reliability.cheap=rigid --set load.max_displacement=8mm; }
case_study_correlated() { study correlated --set uq.samples=8 "${simple[@]}"; }
case_study_spatial() { # the verbs one by one; the page pushes walls again
    run study ../configs/paper_spatial.ini --out study.h5 --quiet --threads 2 --set uq.samples=8 "${simple[@]}"
    run fragility study.h5 --quiet
    run report study.h5 --walls 2 --quiet --threads 2
}
case_curve_hash() { [[ ! -x $hash ]] || "$hash" | sed 's/ *[0-9]* lanes$//' >said; }
case_study_cyclic() { study quick --set uq.samples=4 --set load.vertical_stress=0.5MPa --set joint.wall_modulus=768MPa --set 'load.amplitudes=2, 6 mm'; }
case_push_levels() { push levels --set load.max_displacement=12mm; }
case_study_shaken() {
    run study ../configs/shaken_study.ini --out study.h5 --quiet --threads 2 --set uq.samples=1 --set load.vertical_stress=0.5MPa \
        --set joint.wall_modulus=768MPa --set 'shaking.records=kanai_tajimi(peak 0.3 g, low 1 Hz, duration 2 s, records 2)' \
        --set 'shaking.intensities=0.2, 0.4 g'
    run fragility study.h5 --quiet
}
case_shake() { run shake ../configs/shaken.ini --out . --quiet; }
case_study_layouts() { study rubble --set uq.samples=4 --set load.max_displacement=2mm --set wall.layouts=2 "${simple[@]}"; }
case_push_wall() { push wall; }
case_push_rubble() { push rubble --sample mean --set load.max_displacement=6mm; }
case_push_facade() { push facade --set load.max_displacement=6mm "${simple[@]}"; }
case_push_cyclic() { push wall --set 'load.amplitudes=1, 4 mm' --set load.repeats=2 "${simple[@]}"; }
case_push_picture() { push picture --set load.max_displacement=2mm "${simple[@]}"; }
case_push_drawing() { push drawing --set load.max_displacement=6mm; }
case_scene() {
    local name
    for name in wall facade drawing picture rubble quick; do
        run scene "../configs/$name.ini" --out "$name"
    done
}
case_sample() {
    local name
    for name in quick paper_spatial correlated rubble; do
        run sample "../configs/$name.ini" --out "$name.csv" --quiet --set uq.samples=8
    done
}

# Times, versions and the machine, of each kind of file that has them.
mask_texts() {
    find . -name summary.json -exec sed -Ei \
        's/^(  "(solver_seconds|contact_updates_per_second|commit)": ).*/\1-,/' {} +
    find . -name '*.json' -exec sed -Ei 's/^( *"version": ).*/\1-,/' {} +
    { find . -name '*_summary.csv' -exec grep -l ',seconds of a core$' {} + || :; } | xargs -r sed -Ei '2,$s/,[^,]*$/,-/'
    find . -name 'drystone_*files.txt' -exec sed -Ei 's/^[0-9a-f]+ //' {} + # hashes of files with times
    sed -Ei 's/[0-9.]+ s( |,|$)/- s\1/g; s/[0-9.]+ MB$/- MB/' said
}

mask_stores() {
    local file
    for file in *.h5; do
        [[ -e $file ]] || continue
        if command -v h5dump >/dev/null; then
            h5dump -m '%.17g' "$file" | # numbers behind DATASET are places in the file
                sed -E '/^   GROUP "(cost|sessions)" \{/,/^   \}/d; s/DATASET [0-9]+ "/DATASET "/' >"$file.txt"
        fi
        rm -- "$file"
    done
}

mask_pages() { # the data, which are packed, go into a file of their own
    local page
    for page in *.html; do
        [[ ! -e $page ]] || python3 - "$page" <<'PYTHON'
import base64, json, re, sys, zlib
name = sys.argv[1]
page = open(name, encoding="utf-8").read()
def unpack(match):
    data = json.loads(zlib.decompress(base64.b64decode(match[2])))
    data["provenance"]["version"] = data["provenance"]["sessions"] = None
    with open(name.replace(".html", ".json"), "w", encoding="utf-8") as out:
        json.dump(data, out, indent=1, ensure_ascii=False)
    return match[1] + match[3]
page, found = re.subn(r'(<script[^>]*id="data"[^>]*>)([^<]*)(</script>)', unpack, page)
assert found == 1, name + ": no data found"
open(name, "w", encoding="utf-8").write(page)
PYTHON
    done
}

run_case() { # $1: its name
    mkdir -- "$folder/$1"
    cd -- "$folder/$1"
    "case_$1"
    [[ ! -e said ]] || { mask_texts && mask_stores && mask_pages; }
}

# A series for ParaView is one line: it has a file for each of many moments.
hashes() {
    local path
    find . -mindepth 2 -type f ! -name '*.vtu' -printf '%P\n' | sort |
        while IFS= read -r path; do
            printf '%.16s  %s\n' "$(sha256sum <"$path")" "$path"
        done
    find . -name '*.vtu' -printf '%h\n' | sort -u | while IFS= read -r path; do
        printf '%.16s  %s/*.vtu\n' "$(cat -- "$path"/*.vtu | sha256sum)" "${path#./}"
    done
}

if [[ ${1-} == --case ]]; then # one of them, started below
    program=$2 folder=$3 hash=$4
    run_case "$5"
    exit
fi

accept=no
[[ ${1-} != --accept ]] || { accept=yes && shift; }
[[ -x ${1-} ]] || die "name a program: bash tests/golden.sh build/release/app/drystone"
program=$(readlink -f -- "$1")
hash=${program%/app/*}/bench/curve_hash
folder=$(readlink -m -- "${2-$root/build/golden}")
[[ ! -e $folder || -e $folder/.golden ]] || die "'$folder' is not a folder of this script; name another"
rm -rf -- "$folder"
mkdir -p -- "$folder"
: >"$folder/.golden"
cp -r -- "$root/configs" "$folder/configs"

sed -n 's/^case_\([a-z_]*\)().*/\1/p' "$self" |
    xargs -P "$(nproc)" -I{} bash "$self" --case "$program" "$folder" "$hash" {} || die "a case could not be run"
rm -r -- "$folder/configs"
(cd -- "$folder" && hashes) >"$folder/.golden"

if [[ $accept == yes ]]; then
    cp -- "$folder/.golden" "$list"
    echo "tests/golden.txt: $(wc -l <"$list") outputs"
    exit
fi

declare -A pinned=()
while read -r sum name; do pinned[$name]=$sum; done <"$list"
passed=0 failed=0 skipped=0

differs() { # $1: how; $2: output
    failed=$((failed + 1))
    printf '%-8s %s\n' "$1" "$2"
}

while read -r sum name; do
    if [[ -z ${pinned[$name]-} ]]; then
        differs new "$name"
    elif [[ ${pinned[$name]} != "$sum" ]]; then
        differs moved "$name"
    else
        passed=$((passed + 1))
    fi
    pinned[$name]=''
done <"$folder/.golden"
while read -r _ name; do
    [[ -n ${pinned[$name]} ]] || continue
    if [[ $name == *.h5.txt ]] && ! command -v h5dump >/dev/null; then
        skipped=$((skipped + 1))
    elif [[ $name == curve_hash/* && ! -x $hash ]]; then
        skipped=$((skipped + 1))
    else
        differs missing "$name"
    fi
done <"$list"

((skipped == 0)) || echo "not compared: $skipped outputs that need h5dump (hdf5-tools) or $hash"
if ((failed > 0)); then
    cat <<TEXT
The outputs are in $folder. To see what moved, let a program from before write its own beside them:
    bash tests/golden.sh OLD_PROGRAM /tmp/before; diff -r /tmp/before $folder
If it is meant: bash tests/golden.sh --accept PROGRAM, in a commit that says why each line moved.
TEXT
fi
echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))
