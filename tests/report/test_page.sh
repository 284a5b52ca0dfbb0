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
    "$drystone" study "$here/../study/small.ini" --set uq.samples=12 --out "$folder/small.h5" --quiet
    "$drystone" report "$folder/small.h5" --out "$folder/small.html" --quiet
    "$drystone" report "$folder/small.h5" --out "$folder/few.html" --walls 3 --quiet
else
    folder=$2
    shift 2
    exec node "$here/test_page.mjs" "$chromium" "$folder" "$*"
fi
