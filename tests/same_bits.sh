#!/usr/bin/env bash
# bash tests/same_bits.sh [DIR]   one ensemble and walls of rubble, the same curves to the last bit: through packs and one
# wall at a time, with every register width, g++ and clang++, optimised much and little. Builds in a directory that it removes.
# DIR: the build directory of the Debian package, whose three solvers stand for three of the builds.
set -uo pipefail
package=${1:+$(readlink -f -- "$1")}
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." || exit 1

builds=$(mktemp -d) || exit 1
trap 'rm -rf -- "$builds"' EXIT
passed=0 failed=0 skipped=0 first='' table=()

runs() { # $@: flags of /proc/cpuinfo; whether this processor has them all
    local flag
    for flag in "$@"; do grep -qw -m1 -- "$flag" /proc/cpuinfo || return 1; done
}

row() { table+=("$(printf '%-28s %5s  %-16s  %-16s  %-16s  %6s  %s' "$@")"); }

# With little optimisation each file is compiled alone: that is quick, and shows that it includes what it uses.
unity() { [[ $1 == *-O1* ]] && echo OFF || echo ON; }

build() { # $1: directory, $2: compiler, $3: flags
    cmake -S . -B "$1" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_COMPILER="$2" \
        -DCMAKE_CXX_FLAGS="$3 -DNDEBUG" -DDRYSTONE_WERROR=OFF -DDRYSTONE_BUILD_TESTS=OFF -DDRYSTONE_PYTHON=OFF \
        -DCMAKE_UNITY_BUILD="$(unity "$3")" -DDRYSTONE_PRECOMPILED_HEADERS=OFF >"$1.log" 2>&1 &&
        cmake --build "$1" --target curve_hash >>"$1.log" 2>&1 && return
    tail -n 20 -- "$1.log"
    return 1
}

judge() { # $1: what, $2: SECONDS when it began, $3: what curve_hash wrote; empty: it failed
    local verdict=ok output=$3 packs scalar rubble lanes
    read -r _ packs lanes _ <<<"$(grep '^packs ' <<<"$output")"
    read -r _ scalar <<<"$(grep '^scalar ' <<<"$output")"
    read -r _ rubble <<<"$(grep '^rubble ' <<<"$output")" # through packs and alone, or curve_hash fails
    first=${first:-$packs $rubble} # those of the first build are what all others must have
    [[ -n $packs && -n $rubble && "$packs $rubble" == "$first" && $scalar == "$packs" ]] || verdict=FAILED
    if [[ $verdict == ok ]]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    row "$1" "${lanes:--}" "${packs:--}" "${scalar:--}" "${rubble:--}" $((SECONDS - $2)) "$verdict"
}

try() { # $1: compiler, $2: flags
    local dir=$builds/${#table[@]} begin=$SECONDS output=''
    build "$dir" "$1" "$2" && output=$("$dir/bench/curve_hash") || output=''
    judge "$1 ${2// -mprefer-vector-width=512/}" "$begin" "$output"
    rm -rf -- "$dir"
}

try_or_shipped() { # $1: compiler, $2: flags, $3: the package's name for this instruction set
    local begin=$SECONDS output
    if [[ -z $package ]]; then
        try "$1" "$2"
    else
        wait "${shipped[$3]}" && output=$(<"$builds/$3") || output=''
        judge "the package's $3" "$begin" "$output"
    fi
}

start_shipped() { # $1: the package's name for an instruction set; runs beside the builds
    "$package/packaging/curve_hash-$1" >"$builds/$1" &
    shipped[$1]=$!
}

skip() { # $1: what, $2: why
    skipped=$((skipped + 1))
    row "$1" - - - - - "did not run: $2"
}

declare -A shipped=()
if [[ -n $package ]]; then
    ninja -C "$package" curve_hashes >"$builds/log" 2>&1 || { tail -n 20 -- "$builds/log" && exit 1; }
    start_shipped v1
    ! runs avx2 fma || start_shipped v3
    ! runs avx512f avx512dq avx512vl avx512bw avx512cd || start_shipped v4
fi
row compiler lanes packs scalar rubble seconds ''
try_or_shipped g++ '-O2 -march=x86-64' v1 # no multiply-add instruction
if runs avx2 fma; then
    try_or_shipped g++ '-O3 -march=x86-64-v3' v3
    try g++ '-O1 -march=x86-64-v3'
    if command -v clang++ >/dev/null; then
        try clang++ '-O3 -march=x86-64-v3'
    else
        skip 'clang++ -O3' 'no clang++'
    fi
else
    skip '-march=x86-64-v3' 'no AVX2 and FMA'
fi
if runs avx512f avx512dq avx512vl avx512bw avx512cd; then
    try_or_shipped g++ '-O3 -march=x86-64-v4 -mprefer-vector-width=512' v4
else
    skip 'g++ -march=x86-64-v4' 'no AVX-512'
fi
printf '%s\n' "${table[@]}"
printf '%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
((failed == 0 && passed > 0))
