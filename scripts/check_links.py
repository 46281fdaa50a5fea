#!/usr/bin/env python3
"""Fails when a page points to a file, folder, picture or heading of this project that is not there.

Looked at: relative links and pictures of every *.md outside of build and output folders. Addresses on the web are left alone, code is no link.
"""
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
NO_PAGES = {"build", "out", ".git"}
CODE_BLOCK = re.compile(r"^ {0,3}(```|~~~).*?^ {0,3}\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)", re.DOTALL)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)|^ {0,3}\[[^\]]+\]:\s*(\S+)", re.MULTILINE)
HEADING = re.compile(r"^ {0,3}#{1,6}\s+(.*?)\s*#*\s*$", re.MULTILINE)
ON_THE_WEB = re.compile(r"^[a-z][a-z0-9+.-]*:|^//")


def pages():
    for path in sorted(ROOT.rglob("*.md")):
        if not NO_PAGES & set(path.relative_to(ROOT).parts):
            yield path


def blank(match):
    """Code becomes spaces, so that lines keep their numbers."""
    return re.sub(r"[^\n]", " ", match.group(0))


def anchors(path):
    """What a heading can be reached by: lower case, no punctuation, hyphens for spaces, numbered when repeated."""
    found, seen = set(), {}
    for heading in HEADING.findall(CODE_BLOCK.sub(blank, path.read_text(encoding="utf-8"))):
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "").lower()
        slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        found.add(slug if slug not in seen else f"{slug}-{seen[slug]}")
        seen[slug] = seen.get(slug, 0) + 1
    return found


def problems():
    count = 0
    for page in pages():
        text = CODE.sub(blank, CODE_BLOCK.sub(blank, page.read_text(encoding="utf-8")))
        for match in LINK.finditer(text):
            link = urllib.parse.unquote(match.group(1) or match.group(2))
            if ON_THE_WEB.match(link):
                continue
            count += 1
            where = f"{page.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}"
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.is_relative_to(ROOT):
                yield f"{where}: {link} leaves the project"
            elif not target.exists():
                yield f"{where}: there is no {link}"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                yield f"{where}: {name or page.name} has no heading #{anchor}"
    if count == 0:
        yield "no page has a link: the check looks in the wrong place"


def main():
    found = list(problems())
    print("\n".join(found) if found else "links: every relative link leads somewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
