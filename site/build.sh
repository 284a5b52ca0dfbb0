#!/usr/bin/env bash
# bash site/build.sh [FOLDER]   builds the site in FOLDER, by default build/site, which works from a folder: the documents with
# search, gallery, keys, Python and C++ reference, the page that pushes a wall. Its pages are gathered in FOLDER-pages.
# Exit 77: packages are missing.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
[[ -x /usr/bin/mkdocs && -d /usr/share/mkdocs/themes/material ]] && command -v doxygen >/dev/null || {
    echo "the site takes packages that are not here: sudo apt-get install mkdocs mkdocs-material doxygen python3" >&2
    exit 77
}
DRYSTONE_SITE=$(realpath -m -- "${1-build/site}")
[[ -z $(ls -A -- "$DRYSTONE_SITE" 2>/dev/null) || -f $DRYSTONE_SITE/sitemap.xml ]] || {
    echo "$DRYSTONE_SITE holds files and no site: name another folder, for its files would be deleted" >&2
    exit 2
}
DRYSTONE_SITE_PAGES=$DRYSTONE_SITE-pages
export DRYSTONE_SITE DRYSTONE_SITE_PAGES
/usr/bin/python3 site/pages.py . "$DRYSTONE_SITE_PAGES"
/usr/bin/mkdocs build --quiet --clean --config-file site/mkdocs.yml
rm -- "$DRYSTONE_SITE/404.html" # its links begin at the root of a server
/usr/bin/python3 site/offline_search.py "$DRYSTONE_SITE"
doxygen site/Doxyfile
bash try/build.sh "$DRYSTONE_SITE/try" || echo "without the page that pushes a wall: try/build.sh" >&2
du -sh -- "$DRYSTONE_SITE"
