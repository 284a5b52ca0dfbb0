#!/usr/bin/env python3
"""pages.py ROOT OUT   gathers the pages of the site in OUT: the documents as they lie in the repository, the gallery
(the pictures of README.md and docs/, with their commands), the docstrings of the module."""
import ast
import pathlib
import re
import shutil
import sys

COPIED = ["docs", "configs", "examples", "packaging", "fragility/codes/codes.json", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", "LICENSE"]


def documents(root, out):
    for name in COPIED:
        source, to = root / name, out / name
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(source, to) if source.is_dir() else shutil.copy(source, to)
    text = (root / "README.md").read_text(encoding="utf-8")
    (out / "index.md").write_text(text.replace("# Drystone\n", "# Drystone\n\n[Push a wall in the browser](try.md){ .md-button .md-button--primary }\n", 1), encoding="utf-8")
    # README.md has a new place; Markdown of Python knows neither the name of a file behind a fence nor lists that begin without an empty line
    for page in out.rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        text = re.sub(r"(?m)^```(\w+) +(\S+)$", r"`\2`:\n\n```\1", text)
        text = re.sub(r"\]\((\.\./)*README\.md", lambda m: m.group(0).replace("README.md", "index.md"), text)
        page.write_text(re.sub(r"(?m)^(?!\s*(?:[-*|>#]|\d+\. ))(\S.*)\n(?=(?:- |\| |1\. ))", r"\1\n\n", text), encoding="utf-8")


def gallery(root, out):
    """Pictures of the documents, each with its words and the command that stands nearest before it."""
    seen, items = set(), []
    for page in ["README.md", "docs/pictures.md", "docs/cookbook.md", "docs/drawings.md", "docs/cyclic.md", "docs/validation.md", "docs/tests/comparison.md"]:
        text = (root / page).read_text(encoding="utf-8")
        folder = pathlib.PurePosixPath(page).parent
        for match in re.finditer(r"!\[([^\]]+)\]\(([^)]+\.svg)\)", text):
            path = (root / folder / match[2]).resolve().relative_to(root.resolve()).as_posix()
            if path in seen:
                continue
            seen.add(path)
            line = text[text.rfind("\n", 0, match.start()) + 1:match.start()]
            commands = re.findall(r"`?(\./drystone [^`\n]+)", line) or re.findall(r"(\./drystone [^`\n]+)", text[max(0, match.start() - 600):match.start()])[-1:]
            command = f"<br><code>{commands[-1].strip()}</code>" if commands else ""
            items.append(f'<figure><a href="{path}"><img src="{path}" alt="{match[1]}" loading="lazy"></a><figcaption>{match[1]}{command}</figcaption></figure>')
    (out / "gallery.md").write_text('# Gallery\n\nEvery picture here is drawn by the program.\n\n<div class="gallery">\n' + "\n".join(items) + "\n</div>\n", encoding="utf-8")
    return len(items)


def signature(node):
    return f"{node.name}({ast.unparse(node.args)})" + (f" -> {ast.unparse(node.returns)}" if node.returns else "")


def exceptions(root):
    """Classes of the compiled part that derive from others: what the module throws."""
    tree = ast.parse((root / "python/drystone/_core.pyi").read_text(encoding="utf-8"))
    thrown = [node for node in tree.body if isinstance(node, ast.ClassDef) and node.bases]
    return [f"### {node.name}\n\n```python\nclass {node.name}({ast.unparse(node.bases[0])})\n```\n\n{ast.get_docstring(node) or ''}\n" for node in thrown]


def reference(root, out):
    """Names without an underscore, with their docstrings, without running anything."""
    pages = []
    for file in sorted((root / "python/drystone").glob("*.py*")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        entries = []
        for node in tree.body:
            if not isinstance(node, (ast.FunctionDef, ast.ClassDef)) or node.name.startswith("_"):
                continue
            name = signature(node) if isinstance(node, ast.FunctionDef) else f"class {node.name}"
            entries.append(f"### {node.name}\n\n```python\n{name}\n```\n\n{ast.get_docstring(node) or ''}\n")
            for part in getattr(node, "body", []) if isinstance(node, ast.ClassDef) else []:
                if isinstance(part, ast.FunctionDef) and not part.name.startswith("_") and ast.get_docstring(part):
                    entries.append(f"#### {node.name}.{part.name}\n\n```python\n{signature(part)}\n```\n\n{ast.get_docstring(part)}\n")
        if file.stem == "__init__":
            entries = exceptions(root)
        if entries and file.suffix == ".py":
            module = "drystone" if file.stem.startswith("_") else f"drystone.{file.stem}"
            pages.append(f"## {module}: {file.stem.strip('_').replace('init', 'errors')}\n\n{ast.get_docstring(tree) or ''}\n\n" + "\n".join(entries))
    (out / "python_reference.md").write_text("# Python reference\n\n" + "\n".join(pages), encoding="utf-8")
    return len(pages)


def main(root, out):
    root, out = pathlib.Path(root), pathlib.Path(out)
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    documents(root, out)
    pictures = gallery(root, out)
    modules = reference(root, out)
    (out / "try.md").write_text('---\nhide:\n  - navigation\n  - toc\n---\n# Try it\n\n<a class="md-button" href="try/index.html">On a page of its own</a>\n\n<iframe class="try" src="try/index.html" title="Push a stone wall"></iframe>\n', encoding="utf-8")
    (out / "cpp.md").write_text("# C++ reference\n\nOf the libraries' headers, by Doxygen: <a href=\"cpp/index.html\">open it</a>. How to link: [C++](docs/library.md).\n", encoding="utf-8")
    shutil.copy(root / "site/site.css", out)
    print(f"{pictures} pictures, {modules} Python modules")


if __name__ == "__main__":
    main(*sys.argv[1:])
