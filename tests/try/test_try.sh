#!/usr/bin/env bash
# test_try.sh build FOLDER                    builds the page that pushes a wall in the browser
# test_try.sh module DRYSTONE FOLDER CLAIM... one claim of test_module.mjs about its module, in Node
# test_try.sh page DRYSTONE FOLDER CLAIM...   one claim of test_page.mjs about the page, in Chromium
# Exit 77: clang-19 with its WebAssembly packages, node or chromium is missing.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
what=$1
shift
command -v node >/dev/null || { echo "node is missing"; exit 77; }
case $what in
    build) exec bash "$here/../../try/build.sh" "$1" ;;
    module) exec node "$here/test_module.mjs" "$1" "$2" "${*:3}" ;;
    page)
        chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
            echo "chromium is missing"
            exit 77
        }
        exec node "$here/test_page.mjs" "$chromium" "$1" "$2" "${*:3}"
        ;;
esac
