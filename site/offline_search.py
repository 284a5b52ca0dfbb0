#!/usr/bin/env python3
"""offline_search.py SITE   lets the search of a built site work from a folder: browsers refuse a file:// page its worker and its
index, so that both go into SITE/offline_search.js."""
import json
import pathlib
import sys

SCRIPT = """// written by site/offline_search.py
if (location.protocol === 'file:') {
    window.__search = { index: Promise.resolve(%s) };
    const source = %s;
    const Beside = window.Worker;
    window.Worker = class extends Beside {
        constructor(url, options) {
            super(String(url).includes('/workers/search') ? URL.createObjectURL(new Blob([source], { type: 'text/javascript' })) : url, options);
        }
    };
}
"""


def main(site):
    site = pathlib.Path(site)
    worker = next(site.glob("assets/javascripts/workers/search.*.min.js")).read_text(encoding="utf-8")
    index = (site / "search/search_index.json").read_text(encoding="utf-8")
    (site / "offline_search.js").write_text(SCRIPT % (index, json.dumps(worker)), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
