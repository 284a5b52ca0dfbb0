#!/usr/bin/env python3
"""offline_search.py SITE   lets the search of a built site work from a folder: browsers refuse a file:// page its worker and its
index, so that both go into SITE/offline_search.js, which pages load there alone, before the theme's own script.

The theme posts the index and queries (types 0 and 2), one at a time, and keeps only the last of those that wait for an answer. A word
typed while the worker starts would so replace the index, and the search would never begin: until the index is posted, queries are
answered here, with nothing found. The theme asks the last one again when the index is read."""
import json
import pathlib
import re
import sys

SCRIPT = """// written by site/offline_search.py
{
    window.__search = { index: Promise.resolve(%s) };
    const source = %s;
    const Beside = window.Worker;
    window.Worker = class extends Beside {
        constructor(url, options) {
            super(String(url).includes('/workers/search') ? URL.createObjectURL(new Blob([source], { type: 'text/javascript' })) : url, options);
        }
        postMessage(message) {
            this.indexed ||= message.type !== 2;
            if (this.indexed) super.postMessage(message);
            else queueMicrotask(() => this.dispatchEvent(new MessageEvent('message', { data: { type: 3, data: { items: [] } } })));
        }
    };
}
"""
LOADED = r"""<script>if (location.protocol === 'file:') document.write('<script src="\2offline_search.js"><\/script>');</script>\1"""


def main(site):
    site = pathlib.Path(site)
    worker = next(site.glob("assets/javascripts/workers/search.*.min.js")).read_text(encoding="utf-8")
    index = (site / "search/search_index.json").read_text(encoding="utf-8")
    (site / "offline_search.js").write_text(SCRIPT % (index, json.dumps(worker)), encoding="utf-8")
    found = 0
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        text, count = re.subn(r'(<script src="([^"]*)assets/javascripts/bundle)', LOADED, text)
        found += count
        if count:
            page.write_text(text, encoding="utf-8")
    if found == 0:
        sys.exit("no page loads the script of the theme")


if __name__ == "__main__":
    main(*sys.argv[1:])
