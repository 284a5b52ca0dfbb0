#!/usr/bin/env bash
# bash bench/page.sh FILE.h5|PAGE.html [FOLDER]   measures the page of a study in Chromium and writes FOLDER/page.md, first screens of a desk and
# of a phone as PNG, and the page printed as PDF (default: build/page). DRYSTONE: the program, that of build/unity or build/release.
# Shortest of DRYSTONE_RUNS runs (default 5). Exit 77: packages are missing; 1: an aim is missed.
set -euo pipefail
file=$(readlink -f -- "${1:?write the file of a study or its page}")
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
folder=${2:-build/page}
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) && command -v node >/dev/null || {
    echo "the measurement takes chromium and node: sudo apt-get install chromium nodejs" >&2
    exit 77
}
mkdir -p -- "$folder"
if [[ $file == *.h5 ]]; then
    [[ -n ${DRYSTONE-} ]] || for DRYSTONE in build/{unity,avx512,release}/app/drystone; do [[ -x $DRYSTONE ]] && break; done
    "$DRYSTONE" report "$file" --out "$folder/page.html" --quiet >&2
    file=$(readlink -f -- "$folder/page.html")
fi
exec node bench/page.mjs "$chromium" "$file" "$folder" "${DRYSTONE_RUNS:-5}"
