#!/usr/bin/env bash
# test_site.sh FOLDER   builds the site in FOLDER and reads it. Exit 77: mkdocs, its theme or doxygen is missing.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
bash "$here/../../site/build.sh" "$1" || exit
exec /usr/bin/python3 "$here/test_site.py" "$1" "$here/../.."
