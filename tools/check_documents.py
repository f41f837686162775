#!/usr/bin/env python3
"""Checks what people read: links of the documents lead somewhere, and words are spelt as in a dictionary.

usage: tools/check_documents.py [CLONE]

Looks at the Markdown files of the clone: a relative link must name a file that is there, and its anchor a
heading of that page; no page of docs/guide may be missing from docs/index.md; the version stands everywhere. Where codespell is installed, documents,
comments and messages are spell-checked too. Exit codes: 0 all is well, 1 something is not, each on a line.
"""
import pathlib
import re
import shutil
import subprocess
import sys

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
SPELT = {".cpp", ".hpp", ".py", ".sh", ".mjs", ".html", ".js", ".css", ".cmake", ".md", ".txt"}
# Names, words in use, and what the publication's captions have: a dictionary takes them for misspelt.
TERMS = "lod,vaid,gaus,fro,omited,inbetween"


def text_of(page):
    """The page without its blocks of code, whose brackets are no links."""
    return re.sub(r"```.*?```", "", page.read_text(), flags=re.S)


def anchors(page):
    headings = re.findall(r"^#+ (.*)$", text_of(page), re.M)
    plain = (re.sub(r"[`*_]|\[([^\]]*)\]\([^)]*\)", r"\1", heading) for heading in headings)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in plain}


def broken_links(root, pages):
    for page in pages:
        for target in LINK.findall(text_of(page)):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            there = (page.parent / name).resolve() if name else page
            if not there.exists():
                yield f"{page.relative_to(root)}: the link {target} leads nowhere"
            elif anchor and there.suffix == ".md" and anchor not in anchors(there):
                yield f"{page.relative_to(root)}: {name or page.name} has no heading #{anchor}"


def unlisted_guides(root):
    index = root / "docs/index.md"
    listed = set(LINK.findall(index.read_text())) if index.exists() else set()
    for page in sorted((root / "docs/guide").glob("*.md")):
        if f"guide/{page.name}" not in listed:
            yield f"docs/index.md does not list guide/{page.name}"


def stale_versions(root):
    """Files that state the version by itself."""
    version = re.search(r"project\(wavecurve VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text()).group(1)
    for name, line in (("CITATION.cff", f"version: {version}\n"), ("codemeta.json", f'"version": "{version}"')):
        if line not in (root / name).read_text():
            yield f"{name} does not say version {version}"


def misspelt(root, files):
    if shutil.which("codespell") is None:
        return
    run = subprocess.run(["codespell", "--ignore-words-list", TERMS, *(file for file in files if file.suffix in SPELT)],
                         capture_output=True, text=True, check=False)
    yield from (line.removeprefix(f"{root}/") for line in run.stdout.splitlines())


def main():
    if len(sys.argv) > 2:
        print(__doc__.splitlines()[2], file=sys.stderr)
        return 2
    root = pathlib.Path(sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).parents[1]).resolve()
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True).stdout
    files = [root / name for name in listed.split("\0") if name and (root / name).is_file()]
    pages = [file for file in files if file.suffix == ".md"]
    faults = [*broken_links(root, pages), *unlisted_guides(root), *stale_versions(root), *misspelt(root, files)]
    for fault in faults:
        print(fault)
    print(f"{len(pages)} documents, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
