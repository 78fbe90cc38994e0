#!/usr/bin/env python3
"""check_links.py: every link of a Markdown file leads to a file and heading that are there, every file of ours that it names in
backticks is there, and so is every section of the theory that a comment cites."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([^)\s]+)\)")
NAMED = re.compile(r"`((?:core|render|app|shaders|tests|cmake|assets)/[\w./-]+)`")
SOURCES = {".h", ".cpp", ".glsl", ".frag", ".vert"}
CITED = re.compile(r"theory/(\w+\.md), (\d+(?:\.\d+)?)")


def texts():
    """Our Markdown and sources."""
    yield from sorted(ROOT.glob("*.md"))
    for folder in ("core", "render", "app", "shaders", "tests", "assets"):
        yield from (file for file in sorted((ROOT / folder).rglob("*")) if file.suffix in {".md", *SOURCES})


def prose(file):
    return re.sub(r"^```.*?^```", "", file.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def anchors(file):
    """The names that headings get on a web page: small letters, hyphens for blanks, no other marks."""
    headings = re.findall(r"^#+ (.+)$", prose(file), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(file):
    for link in LINK.findall(prose(file)):
        if re.match(r"https?:|mailto:", link):
            continue
        path, _, anchor = link.partition("#")
        target = file.parent / path if path else file
        if not target.exists() or anchor and anchor not in anchors(target):
            yield f"no such link: {link}"


def missing_files(file):
    for name in NAMED.findall(prose(file)):
        if not any((ROOT / (name + ending)).exists() for ending in ("", ".h", ".cpp")):
            yield f"no such file: {name}"


def missing_sections(file):
    for theory, section in CITED.findall(file.read_text(encoding="utf-8")):
        text = (ROOT / "assets/docs/theory" / theory).read_text(encoding="utf-8")
        if not re.search(rf"^(?:\*\*|#+ ){re.escape(section)}\.?(?: |\*\*)", text, re.MULTILINE):
            yield f"no such section: {theory}, {section}"


failures = []
for file in texts():
    checks = [missing_sections] if file.suffix in SOURCES else [missing_sections, broken_links, missing_files]
    failures += [f"{file.relative_to(ROOT)}: {words}" for check in checks for words in check(file)]
print("\n".join(failures), end="\n" if failures else "")
sys.exit(bool(failures))
