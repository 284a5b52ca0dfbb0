#!/usr/bin/env bash
# test_install.sh BUILD ROOT PROGRAM   installs the libraries, then uses them as another project would: find_package and
# pkg-config. Exit code 0: all is there and gives the bits of the command line, 1: not so.
set -euo pipefail
build=$(readlink -f -- "$1") root=$(readlink -f -- "$2") program=$(readlink -f -- "$3")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
die() { echo "$*" >&2; exit 1; }
quietly() { "$@" >"$work/said" 2>&1 || { cat "$work/said" >&2; die "failed: $*"; }; }

quietly cmake --install "$build" --component development --prefix "$work/usr"
include=$work/usr/include/drystone

# What an installed header includes is installed, and nothing installed names the source tree.
while IFS=: read -r file header; do
    [[ -f $include/$header ]] || die "$file: $header is not installed"
done < <(cd "$include" && grep -roE '^#include "[^"]+"' . | sed -E 's/#include "(.*)"/\1/')
! grep -rIl --include='*.cmake' --include='*.pc' --include='*.hpp' -e "$root" "$work/usr" || die "names the source tree"
for private in contact/pack.hpp solver/step/step.hpp; do
    [[ ! -e $include/dem/$private ]] || die "installed, but private: $private"
done

# By CMake, with no flag of ours: then the numbers of the command line.
quietly cmake -G Ninja -S "$root/examples/cpp" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS="${DRYSTONE_CXX_FLAGS-}" -DCMAKE_CXX_COMPILER="${CXX-g++}"
quietly cmake --build "$work/cmake" --verbose
! grep -E -- '-W(all|error|extra)|-fno-tree-vectorize|-ffp-contract' "$work/said" || die "a flag of ours reaches the user"
"$work/cmake/push_one_wall" >"$work/example"
"$program" push "$root/configs/wall.ini" --out "$work/wall" --quiet >/dev/null
while read -r key value; do
    grep -q "\"$key\"" "$work/wall/summary.json" || die "$key: not in summary.json"
    python3 - "$key" "$value" "$work/wall/summary.json" <<'PYTHON' || die "$key: not the number of the command line, which has 15 digits"
import json, sys
key, value, file = sys.argv[1:]
sys.exit(json.load(open(file))[key] != float(value))
PYTHON
done <"$work/example"
(($(wc -l <"$work/example") == 3)) || die "the example says too little"

# By pkg-config; and every public header of the other libraries is whole.
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(find "$work/usr" -name pkgconfig)
if command -v pkg-config >/dev/null; then
    for part in core uq fragility ground; do
        (cd "$work/usr/include" && find "drystone/$part" -name '*.hpp' | sort | sed 's/.*/#include <&>/') >"$work/$part.cpp"
        cat >>"$work/$part.cpp" <"$root/tests/install/use_$part.cpp"
        # shellcheck disable=SC2046
        quietly "${CXX-g++}" ${DRYSTONE_CXX_FLAGS-} "$work/$part.cpp" -o "$work/use_$part" $(pkg-config --cflags --libs --static "drystone-$part")
        quietly "$work/use_$part"
    done
fi
echo "installed, found, linked; same bits"
