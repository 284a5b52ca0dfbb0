#!/usr/bin/env bash
# bash bench/try.sh [OUT.md]   builds the page that pushes a wall in the browser and measures it in Chromium: size, first picture, a push,
# fifty walls, memory. OUT.md: default docs/bench/speed/try.md. Shortest of DRYSTONE_RUNS runs (default 3).
# Exit 77: packages are missing; 1: an aim is missed.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
out=${1:-docs/bench/speed/try.md}
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) && command -v node >/dev/null || {
    echo "the measurement takes chromium and node: sudo apt-get install chromium nodejs" >&2
    exit 77
}
folder=${DRYSTONE_TRY:-build/try}
bash try/build.sh "$folder" >&2
mkdir -p -- "$(dirname -- "$out")"
exec node bench/try.mjs "$chromium" "$folder" "$out" "${DRYSTONE_RUNS:-3}"
