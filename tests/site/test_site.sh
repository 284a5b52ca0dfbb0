#!/usr/bin/env bash
# test_site.sh build FOLDER    builds the site in FOLDER and reads it
# test_site.sh search FOLDER   searches it in Chromium
# Exit 77: mkdocs, its theme, doxygen, or node, chromium is missing.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
case $1 in
    build)
        bash "$here/../../site/build.sh" "$2" || exit
        exec /usr/bin/python3 "$here/test_site.py" "$2" "$here/../.."
        ;;
    search)
        command -v node >/dev/null || { echo "node is missing"; exit 77; }
        chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || { echo "chromium is missing"; exit 77; }
        [[ -f $2/index.html ]] || { echo "the site was not built"; exit 77; }
        exec node "$here/test_search.mjs" "$chromium" "$2"
        ;;
esac
