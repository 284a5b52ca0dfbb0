#!/usr/bin/env bash
# test_study.sh PROGRAM COMPARE CLAIM   a claim about `drystone study`: function claim_CLAIM below
set -euo pipefail

program=$1 compare=$2 claim=$3
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
mounted=''
cleanup() {
    [[ -z $mounted ]] || umount "$mounted" || :
    rm -rf -- "$work"
}
trap cleanup EXIT

fail() {
    echo "$*" >&2
    exit 1
}

study() { # $1: name of the file; then options
    local file=$work/$1.h5
    shift
    "$program" study "$here/small.ini" --out "$file" --quiet "$@"
}

same() { # $1, $2: names; $3: samples
    "$compare" "$work/$1.h5" "$work/$2.h5" "${@:3}" || fail "$1 and $2 differ"
}

refused() { # $1: exit code; $2: part of what is said; then the command
    local code=0
    "${@:3}" >"$work/said" 2>&1 || code=$?
    [[ $code == "$1" ]] || fail "exit code $code: $(cat "$work/said")"
    grep -qF -- "$2" "$work/said" || fail "not said: $2; but: $(cat "$work/said")"
}

claim_twelve_kills_and_as_many_resumes_change_no_bit() {
    local kills=0 code size=(--set uq.samples=600 --set uq.audit=20 --threads 2)
    study whole "${size[@]}"
    while ((kills < 12)); do
        "$program" study "$here/small.ini" --out "$work/killed.h5" --quiet "${size[@]}" >/dev/null &
        sleep "0.$((RANDOM % 4))$((RANDOM % 10))"
        kill -KILL $! 2>/dev/null || :
        code=0
        wait $! 2>/dev/null || code=$?
        if ((code == 0)); then # it was done before the kill: once more from the beginning
            same whole killed
            rm -- "$work/killed.h5"
            continue
        fi
        ((code == 137)) || fail "exit code $code after $kills kills"
        kills=$((kills + 1))
        [[ ! -e $work/killed.h5 ]] || "$compare" "$work/killed.h5" "$work/killed.h5" || fail "damaged"
    done
    study killed "${size[@]}"
    same whole killed
}

claim_threads_and_shards_change_no_bit() {
    local n i files audit=(--set uq.audit=3)
    study whole "${audit[@]}" --threads 2
    study one "${audit[@]}" --threads 1
    same whole one
    for n in 1 4 16; do
        files=()
        for ((i = 1; i <= n; ++i)); do study "s$n" "${audit[@]}" --shard "$i/$n" >/dev/null; done
        ((n > 1)) || { same whole s1; continue; }
        for i in "$work/s$n"_*_of_"$n".h5; do files+=("$i"); done
        "$program" merge "$work/m$n.h5" "${files[@]}"
        same whole "m$n"
    done
    refused 2 "shard 1 of 16 is missing: $work/s16_01_of_16.h5" "$program" merge "$work/gap.h5" "${files[@]:1}"
    [[ ! -e $work/gap.h5 ]] || fail "a file with a gap was written"
    "$program" merge "$work/part.h5" "${files[@]:1}" --partial >"$work/said" || fail "asked for, but exit code $?"
    grep -q '^5 of [0-9]* walls have not been run yet' "$work/said" || fail "$(cat "$work/said")"
}

claim_files_of_strangers_are_refused_by_name_and_nothing_is_written() {
    /usr/bin/python3 -c 'import h5py' 2>/dev/null || exit 77
    local craft verb file=$work/stranger.h5 before all="fragility report curves push merge study"
    study one --set uq.samples=4 >/dev/null
    open_by() { # $1: verb
        case $1 in
        fragility | curves) "$program" "$1" "$file" --out "$work/out" --quiet ;;
        report) "$program" report "$file" --out "$work/out" --walls 0 --quiet ;;
        push) "$program" push "$file" --sample 1 --level 0.5 --out "$work/out" --quiet ;;
        merge) "$program" merge "$work/out" "$file" ;;
        study) study stranger --set uq.samples=4 ;;
        esac
    }
    for craft in "stack:$all" "heap:$all" "sizes:$all" "column:$all" "outside:$all" "nan:${all/push/}" \
        "fall:fragility report merge study" "configuration:fragility report push merge"; do
        /usr/bin/python3 "$here/craft_study.py" "$work/one.h5" "$file" "${craft%:*}"
        before=$(cksum <"$file")
        for verb in ${craft#*:}; do
            refused 2 "stranger.h5" open_by "$verb"
            [[ $(cksum <"$file") == "$before" && -z $(compgen -G "$work/out*"; compgen -G "$work/.out*") ]] ||
                fail "$craft: $verb wrote something"
            [[ ! -e $file.parts && ! -e $file.lock ]] || fail "$craft: $verb left something"
        done
    done
    rm -- "$file"
    refused 2 "stranger.h5': no such file" open_by fragility
    /usr/bin/python3 "$here/craft_study.py" "$work/one.h5" "$file" zeros
    "$program" report "$file" --out "$work/zeros.html" --walls 0 --quiet >/dev/null || fail "a wall may carry nothing"
}

claim_random_layouts_have_the_same_bits_by_threads_shards_resumes_and_alone() {
    local layouts=(--set wall.bond=rubble --set wall.layouts=7) i size=(--set uq.samples=16 --set uq.audit=2)
    study whole "${layouts[@]}" "${size[@]}" --threads 2
    study one "${layouts[@]}" "${size[@]}" --threads 1
    study more "${layouts[@]}" "${size[@]}" --threads 9
    same whole one
    same whole more
    for i in 1 2 3; do study part "${layouts[@]}" "${size[@]}" --shard "$i/3" >/dev/null; done
    "$program" merge "$work/merged.h5" "$work"/part_*_of_3.h5
    same whole merged
    "$program" study "$here/small.ini" --out "$work/killed.h5" --quiet "${layouts[@]}" "${size[@]}" >/dev/null &
    sleep 0.3
    kill -KILL $! 2>/dev/null || :
    wait $! || :
    study killed "${layouts[@]}" "${size[@]}"
    same whole killed
    study grown "${layouts[@]}" --set uq.design=monte_carlo --set uq.samples=9
    study grown "${layouts[@]}" --set uq.design=monte_carlo "${size[@]}"
    study fresh "${layouts[@]}" --set uq.design=monte_carlo "${size[@]}"
    same fresh grown
    # Wall 9 lies in layout 9 % 7 = 2, whose seed is 1 + 2; alone it has the same curve.
    "$program" push "$work/whole.h5" --sample 9 --level 0.50 --out "$work/nine" --quiet >/dev/null
    grep -q '^seed  *= 3 ' "$work/nine/study.ini" || fail "another seed: $(cat "$work/nine/study.ini")"
    "$program" push "$here/small.ini" --set wall.bond=rubble --set wall.seed=3 "${size[@]}" --sample 9 --level 0.50 \
        --out "$work/alone" --quiet >/dev/null
    cmp "$work/nine/capacity.csv" "$work/alone/capacity.csv" || fail "not the wall of this seed"
    "$program" curves "$work/whole.h5" --out "$work/curves.csv" >/dev/null
    [[ $(awk -F, '$1 == 0 && $3 == 9 {n = $5} END {print n}' "$work/curves.csv") == \
        $(awk -F, 'END {printf "%.9g", $3}' "$work/nine/capacity.csv") ]] || fail "not the wall of the study"
}

claim_more_samples_add_walls_and_keep_the_old() {
    local design
    for design in monte_carlo sobol; do
        study "grown_$design" --set uq.design="$design" --set uq.samples=50
        study "grown_$design" --set uq.design="$design" --set uq.samples=100
        study "whole_$design" --set uq.design="$design" --set uq.samples=100
        same "whole_$design" "grown_$design"
    done
    study latin --set uq.samples=50
    cp "$work/latin.h5" "$work/fifty.h5"
    study latin --set uq.samples=100
    same fifty latin 50
    "$program" sample "$work/latin.h5" --out "$work/latin.csv" >/dev/null
    # column 5 is uniform on [0.5, 1.5]: each of 100 strata once at each of the two levels
    [[ $(awk -F, 'NR > 1 {print $1, int(($5 - 0.5) * 100)}' "$work/latin.csv" | sort -u | wc -l) == 200 ]] ||
        fail "not Latin as a whole"
    refused 2 "has 100 samples at 0.5 MPa, only 60 are wanted" "$program" study "$here/small.ini" --out "$work/latin.h5" --set uq.samples=60
}

claim_other_inputs_are_refused_with_the_difference() {
    study one
    refused 2 "joint.friction_angle" "$program" study "$here/small.ini" --out "$work/one.h5" \
        --set 'joint.friction_angle=normal(mean 30 deg, cov 0.20)'
    cp "$work/one.h5" "$work/before.h5"
    study one --set 'joint.friction_angle=normal(mean 31.8 deg, cov 0.20)' --set uq.samples=4e1
    same one before
}

claim_walls_that_fail_are_kept_named_and_counted() {
    local code=0
    study failed --set solver.energy_tolerance=1e-14 --set uq.samples=3 >"$work/said" || code=$?
    [[ $code == 1 ]] || fail "exit code $code"
    grep -q '6 failed: the energy ledger does not close' "$work/said" || fail "$(cat "$work/said")"
    grep -q '0.50 MPa sample 0' "$work/said" || fail "not named: $(cat "$work/said")"
    # run again alone, they fail again, the same bits
    cp "$work/failed.h5" "$work/first.h5"
    study failed --set solver.energy_tolerance=1e-14 --set uq.samples=3 --rerun-failed >/dev/null || :
    same first failed
}

claim_a_full_disk_is_said_and_survived() {
    [[ $(id -u) == 0 ]] && mkdir "$work/disk" && mount -t tmpfs -o size=192k tmpfs "$work/disk" 2>/dev/null ||
        exit 77
    mounted=$work/disk
    refused 1 'disk' "$program" study "$here/small.ini" --out "$work/disk/s.h5" --quiet
    "$compare" "$work/disk/s.h5" "$work/disk/s.h5" >/dev/null || fail "the file is not valid"
    mount -o remount,size=16m "$work/disk"
    "$program" study "$here/small.ini" --out "$work/disk/s.h5" --quiet
    study whole
    "$compare" "$work/whole.h5" "$work/disk/s.h5"
}

claim_a_push_to_and_fro_has_the_peak_of_its_backbone() {
    sed 's/^max_displacement.*/targets = 2, -2 mm/' "$here/small.ini" >"$work/cyclic.ini"
    "$program" study "$work/cyclic.ini" --out "$work/cyclic.h5" --set uq.samples=2 --quiet >"$work/said" ||
        fail "$(cat "$work/said")"
    grep -qE '^ +0\.5 +2 +0 +[0-9.]+ \+- ' "$work/said" || fail "$(cat "$work/said")"
}

claim_tables_and_page_follow_where_asked() {
    local file
    study small --set uq.samples=3 --report >"$work/said"
    (($(grep -c ' still carried more than ' "$work/said") == 1)) || fail "not told once: $(cat "$work/said")"
    for file in small/README.md small/tables/means_by_mode.md small/performance_limits.csv; do
        [[ -s $work/$file ]] || fail "no $file"
    done
    grep -q '</html>' "$work/small.html" || fail "no page"
    study small --set uq.samples=5 --report # walls filmed while they are pushed, and three from before
    "$program" report "$work/small.h5" --out "$work/again.html" --quiet # all of them pushed again
    cmp "$work/small.html" "$work/again.html" || fail "another page"
    "$program" study "$here/small.ini" --out "$work/other.hdf5" --set uq.samples=2 --report --quiet >/dev/null 2>&1 ||
        fail "the name of a study's file need not end in .h5"
    [[ -s $work/other/README.md && -s $work/other.html ]] || fail "no tables or page of other.hdf5"
    head -c 2000 "$work/other.hdf5" >"$work/cut.hdf5"
    refused 2 "cut.hdf5' is damaged" "$program" fragility "$work/cut.hdf5"
    refused 2 "a shard has no report" study part --shard 1/2 --report
    refused 2 "a shard has no report" study part --slurm "$work/job.sh" --report
}

claim_a_study_that_goes_on_counts_what_was_there() {
    study whole --set uq.samples=4 --set uq.design=monte_carlo >/dev/null
    study whole --set uq.samples=10 --set uq.design=monte_carlo >"$work/said"
    grep -qx '20 walls in the file: 8 from before, 12 of this run' "$work/said" || fail "$(cat "$work/said")"
    "$program" study "$here/small.ini" --out "$work/part.h5" --set uq.samples=2 --shard 1/3 >/dev/null 2>"$work/said"
    grep -q 'this shard has walls under' "$work/said" || fail "$(cat "$work/said")"
    "$program" study "$here/small.ini" --out "$work/part.h5" --set uq.samples=10 --shard 1/5 >/dev/null 2>"$work/said"
    ! grep -q 'note:' "$work/said" || fail "$(cat "$work/said")"
}

claim_two_runs_on_one_file_are_refused() {
    "$program" study "$here/small.ini" --out "$work/one.h5" --set uq.samples=2000 --threads 1 --quiet >/dev/null 2>&1 &
    local first=$!
    for _ in {1..1500}; do [[ ! -e $work/one.h5 ]] || break; sleep 0.02; done
    refused 1 'is held by process' "$program" study "$here/small.ini" --out "$work/one.h5" --set uq.samples=2000
    sleep 1
    kill -TERM "$first"
    wait "$first" && fail "not interrupted" || :
    "$compare" "$work/one.h5" "$work/one.h5" # what it had is there
}

claim_a_job_array_has_any_name_and_merges_its_shards() {
    local name="a @out@ 'b' \$(touch PWNED) 10%a" ending i
    cd "$work"
    cp "$here/small.ini" "$name.ini"
    study whole
    for ending in .h5 .hdf5; do
        "$program" study "$name.ini" --out "$name$ending" --slurm job.sh --shard '*/2' --quiet >/dev/null
        for i in 1 2; do SLURM_JOB_ID=1 SLURM_ARRAY_TASK_ID=$i bash job.sh >/dev/null; done
        SLURM_JOB_ID=1 bash job.sh merge >/dev/null || fail "not merged: $name$ending"
        "$compare" whole.h5 "$name$ending" || fail "$name$ending differs"
    done
    [[ ! -e PWNED ]] || fail "a name was run as a command"
    sbatch() { printf '%s\n' "$@" >>sent; echo 7; }
    export -f sbatch
    bash job.sh --partition=x >/dev/null
    grep -qxF -- "--output=$work/${name//%/%%}.hdf5.logs/%a.log" sent || fail "$(cat sent)"
    refused 2 'give uq.samples' "$program" study "$name.ini" --slurm job.sh --set uq.stop=mixed_share
}

claim_no_verb_replaces_what_it_did_not_write() {
    local size=(--set uq.samples=6) ini=$here/small.ini out file verb
    study one "${size[@]}" >/dev/null
    run_verb() { # $1: verb
        case $1 in
        scene | push) "$program" "$1" "$ini" --set joint.friction_angle="30 deg" --set joint.stiffness_factor=1 \
            --set unit.tensile_strength="3.7 MPa" --out "$work/$1" ;;
        sample) "$program" sample "$ini" "${size[@]}" --out "$work/sample.csv" ;;
        slurm) "$program" study "$ini" "${size[@]}" --out "$work/array.h5" --slurm "$work/slurm.sh" --shard '*/2' ;;
        study) "$program" study "$ini" "${size[@]}" --out "$work/two.h5" --report ;;
        curves) "$program" curves "$work/one.h5" --out "$work/curves.csv" ;;
        report) "$program" report "$work/one.h5" --walls 0 --out "$work/report.html" ;;
        fragility) "$program" fragility "$work/one.h5" --out "$work/fragility" ;;
        esac
    }
    for out in scene/scene.dxf push/levels.svg sample.csv slurm.sh two_summary.md two/README.md two.html curves.csv \
        report.html fragility/fragility.json; do
        verb=${out%%[./]*}
        verb=${verb/two*/study}
        file=$work/$out
        mkdir -p "${file%/*}"
        echo mine >"$file"
        refused 2 'exists already' run_verb "$verb"
        [[ $(cat "$file") == mine ]] || fail "$verb replaced $out"
        rm -- "$file"
    done
    [[ ! -e $work/two.h5 ]] || fail "walls were pushed before the names were looked at"
    for verb in scene push sample slurm curves report fragility; do
        run_verb "$verb" >/dev/null 2>"$work/said"
        ! grep -q 'replaced' "$work/said" || fail "$(cat "$work/said")"
        run_verb "$verb" >/dev/null 2>"$work/said"
        grep -q 'replaced' "$work/said" || fail "$verb does not say that it replaces its earlier result"
    done
}

claim_what_cannot_be_written_is_said() {
    refused 1 'cannot write to standard output' bash -c '"$@" >/dev/full' _ "$program" study "$here/small.ini" \
        --out "$work/a.h5" --quiet
    refused 1 'raise the limit of file sizes' bash -c 'ulimit -f 20; "$@"' _ "$program" study "$here/small.ini" \
        --out "$work/b.h5" --quiet
    study b
    same a b
    echo precious >"$work/precious"
    ln -s precious "$work/c.h5.lock"
    refused 1 "cannot write '$work/c.h5.lock'" "$program" study "$here/small.ini" --out "$work/c.h5" --quiet
    [[ $(cat "$work/precious") == precious ]] || fail "written through a link"
}

"claim_$claim"
