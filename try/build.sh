#!/usr/bin/env bash
# bash try/build.sh [FOLDER]   builds the solver for the browser and its page: FOLDER/index.html and FOLDER/drystone.wasm, by
# default in build/try. Exit 77: packages are missing.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
out=${1-build/try}
packages=(clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 libeigen3-dev libboost-dev nlohmann-json3-dev librandom123-dev cmake ninja-build)
missing=()
for package in "${packages[@]}"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
done
if ((${#missing[@]})); then
    echo "the page takes packages that are not here: sudo apt-get install ${missing[*]}" >&2
    exit 77
fi
work=${DRYSTONE_TRY_BUILD:-build/try/wasm}
cache=()
! command -v ccache >/dev/null || cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
mkdir -p -- "$work"
cmake -S try -B "$work" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$PWD/try/wasm/toolchain.cmake" "${cache[@]}" >"$work.log" 2>&1 || { cat -- "$work.log"; exit 1; }
ninja -C "$work" --quiet
mkdir -p -- "$out"
cp -- "$work/index.html" "$work/drystone.wasm" "$out"
printf '%s: %d kB, its module %d kB\n' "$out/index.html" $(($(stat -c %s "$out/index.html") / 1024)) $(($(stat -c %s "$out/drystone.wasm") / 1024))
