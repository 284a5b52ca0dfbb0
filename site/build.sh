#!/usr/bin/env bash
# bash site/build.sh   builds the site in build/site, which works from a folder: the documents with search, gallery, keys,
# Python and C++ reference, the page that pushes a wall.
# Exit 77: packages are missing.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
for command in mkdocs doxygen python3; do
    command -v "$command" >/dev/null || {
        echo "the site takes packages that are not here: sudo apt-get install mkdocs mkdocs-material doxygen python3" >&2
        exit 77
    }
done
/usr/bin/python3 site/pages.py . build/site-pages
/usr/bin/mkdocs build --quiet --clean --config-file site/mkdocs.yml
/usr/bin/python3 site/offline_search.py build/site
doxygen site/Doxyfile
bash try/build.sh build/site/try || echo "without the page that pushes a wall: try/build.sh" >&2
du -sh build/site
