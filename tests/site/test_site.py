#!/usr/bin/python3
"""test_site.py SITE ROOT   reads a built site as a browser does, from its folder: every document of ROOT is a page that links lead
to and that the search finds, every link has its target, both references name what the sources name. Exit code 0: so, 1: not so."""
import ast
import html
import html.parser
import json
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """Links and anchors of one page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def documents(root):
    """Pages of the site by the documents that they show."""
    found = {"index.html": root / "README.md", "CHANGELOG.html": root / "CHANGELOG.md", "CONTRIBUTING.html": root / "CONTRIBUTING.md"}
    for file in (root / "docs").rglob("*.md"):
        found[file.relative_to(root).with_suffix(".html").as_posix()] = file
    return found


def bare(text):
    return re.sub(r"\W", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text))


def headings(document):
    """Of the second level, without those that stand in examples."""
    text = re.sub(r"(?ms)^```.*?^```", "", document.read_text(encoding="utf-8"))
    return [bare(line[3:]) for line in text.splitlines() if line.startswith("## ")]


def dead_links(site, pages):
    """Of pages by name; those of Doxygen are looked at where others lead into them."""
    for name, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or link.startswith("//"):
                continue
            to = (site / name).parent / urllib.parse.unquote(url.path) if url.path else site / name
            to = (to / "index.html" if to.is_dir() else to).resolve()
            if not to.is_file():
                yield f"{name}: {link}: no such file"
                continue
            target = pages.get(to.relative_to(site).as_posix()) if to.is_relative_to(site) else None
            if target and url.fragment and urllib.parse.unquote(url.fragment) not in target.anchors | {"__search", "__drawer"}:
                yield f"{name}: {link}: no such place on the page"


def reached(site, pages):
    """Pages that links lead to from the first."""
    seen, left = set(), ["index.html"]
    while left:
        name = left.pop()
        if name in seen or name not in pages:
            continue
        seen.add(name)
        for link in pages[name].links:
            url = urllib.parse.urlsplit(link)
            if not url.scheme and url.path:
                to = ((site / name).parent / urllib.parse.unquote(url.path)).resolve()
                left += [to.relative_to(site).as_posix()] if to.is_relative_to(site) else []
    return seen


def python_names(root):
    for node in ast.parse((root / "python/drystone/__init__.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            yield from ast.literal_eval(node.value)


def troubles(site, root):
    names = [p.relative_to(site).as_posix() for p in site.rglob("*.html")]
    pages = {n: Page((site / n).read_text(encoding="utf-8")) for n in names if not n.startswith(("cpp/", "try/"))}
    yield from (f"not a page of the site: {file}" for name, file in documents(root).items() if name not in pages)
    yield from dead_links(site, pages)
    there = reached(site, pages)
    yield from (f"no link leads to {name}" for name in documents(root) if name in pages and name not in there)

    index = json.loads((site / "search/search_index.json").read_text(encoding="utf-8"))["docs"]
    for name, file in documents(root).items():
        titles = {bare(html.unescape(entry["title"])) for entry in index if entry["location"].split("#")[0] == name}
        if not titles:
            yield f"the search does not know {name}"
        yield from (f"the search of {name} lacks the heading {title}" for title in headings(file) if title not in titles)
    offline = (site / "offline_search.js").read_text(encoding="utf-8")
    if '"location": "docs/keys.html"' not in offline.replace('":"', '": "'):
        yield "the search from a folder has no index"
    yield from (f"{name}: its search works on a server alone" for name in documents(root) if name in pages and "offline_search.js" not in (site / name).read_text(encoding="utf-8"))

    python = (site / "python_reference.html").read_text(encoding="utf-8")
    public = list(python_names(root))
    if len(public) < 5:
        yield "the module names too little"
    modules = {file.stem for file in (root / "python/drystone").glob("*.py")}
    yield from (f"the Python reference lacks {name}" for name in public if (f"drystone.{name}:" if name in modules else f'id="{name.lower()}"') not in python)
    headers = [h.name for part in ("core", "dem", "uq", "fragility", "ground") for h in (root / part).rglob("*.hpp")]
    files = (site / "cpp/files.html").read_text(encoding="utf-8")
    yield from (f"the C++ reference lacks {name}" for name in headers if f">{name}<" not in files)


def main(site, root):
    found = list(troubles(pathlib.Path(site).resolve(), pathlib.Path(root).resolve()))
    print("\n".join(found) or "every document is there, every link has its target")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
