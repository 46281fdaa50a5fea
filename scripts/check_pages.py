#!/usr/bin/env python3
"""Fails when a page has a sentence nobody can follow, a line that has to be scrolled, a commit hash, or has grown too long.

For every *.md outside of build and output folders:

- No sentence over 45 words. Not read: code blocks, tables, headings, maths blocks, pictures, HTML comments. A piece of `code`, a formula
  between $ and an address are one word each, a link is its text. A list item and a paragraph end the sentence in them.
- No line over 300 characters, code and tables too. Of generated pages, which say `<!-- written by COMMAND -->` in their first three lines,
  rows of tables may be longer: they hold what the data hold.
- No commit hash (7 to 40 hexadecimal digits with both a digit and a letter) except in generated pages, which carry the program they
  describe, and in addresses on the web, which pin what somebody else has written.
- docs/proof/README.md at most 1500 words, diagnosis/README.md at most 150 lines, CHANGELOG.md at most 60 lines a version.

    scripts/check_pages.py [PAGE…]
"""
import pathlib
import re
import sys

from check_links import CODE, CODE_BLOCK, ROOT, blank, pages

MOST_WORDS, MOST_CHARACTERS = 45, 300
MOST_WORDS_OF_PAGE = {"docs/proof/README.md": 1500}
MOST_LINES_OF_PAGE = {"diagnosis/README.md": 150}
MOST_LINES_OF_VERSION = {"CHANGELOG.md": 60}

GENERATED = re.compile(r"<!-- written by ")
TABLE_ROW = re.compile(r"^\s*\|")
ADDRESS = re.compile(r"<?\bhttps?://[^\s)>\]]+>?")
HASH = re.compile(r"(?<![\w.+-])(?=[0-9a-f]*[0-9])(?=[0-9a-f]*[a-f])(?!\d+e\d+\b)[0-9a-f]{7,40}(?![\w])")
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
MATHS_BLOCK = re.compile(r"\$\$.*?\$\$", re.DOTALL)
MATHS = re.compile(r"\$(?!\s)[^$\n]*(?:\n[^$\n]+)?\$")
PICTURE = re.compile(r"!\[[^\]]*\]\([^)]*\)")
LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")
NOT_PROSE = re.compile(r"^\s*(\||#{1,6}\s|</?\w+[^>]*>\s*$)")
BEGINS = re.compile(r"^\s*(?:>\s*)*(?:[-*+]|\d+[.)])\s+")
ENDS = re.compile(r"(?<!\be\.g)(?<!\bi\.e)(?<!\bal)(?<!\bEq)(?<!\beq)(?<!\bFig)(?<!\bcf)(?<!\bNo)(?<!\bvs)[.!?][)\"'*_”]*(?=\s|$)")


def is_generated(text):
    return bool(GENERATED.search("\n".join(text.splitlines()[:3])))


def one_word(word):
    """What replaces a match by one word, its line ends kept so that lines keep their numbers."""
    return lambda match: word + "\n" * match.group(0).count("\n")


def prose(text):
    """The page without what is no sentence, line for line."""
    for pattern in (COMMENT, CODE_BLOCK, MATHS_BLOCK, PICTURE):
        text = pattern.sub(blank, text)
    for pattern in (CODE, MATHS):
        text = pattern.sub(one_word("code"), text)
    return ADDRESS.sub("address", LINK.sub(lambda match: match.group(1), text))


def blocks(text):
    """(first line, lines) of every paragraph and list item."""
    begin, block = 0, []
    for number, line in enumerate([*text.split("\n"), ""], 1):
        apart = not line.strip() or NOT_PROSE.match(line)
        if block and (apart or BEGINS.match(line)):
            yield begin, block
            block = []
        if not apart:
            begin = begin if block else number
            block.append(BEGINS.sub("", line))
    if block:
        yield begin, block


def long_sentences(text):
    for begin, block in blocks(prose(text)):
        joined, start = "\n".join(block), 0
        for stop in [match.end() for match in ENDS.finditer(joined)] + [len(joined)]:
            sentence = joined[start:stop]
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if len(words) > MOST_WORDS:
                line = begin + joined.count("\n", 0, start + len(sentence) - len(sentence.lstrip()))
                yield line, f"a sentence of {len(words)} words, at most {MOST_WORDS}: {' '.join(words[:8])} …"
            start = stop


def long_lines(text):
    generated = is_generated(text)
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > MOST_CHARACTERS and not (generated and TABLE_ROW.match(line)):
            yield number, f"a line of {len(line)} characters, at most {MOST_CHARACTERS}"


def hashes(text):
    if is_generated(text):
        return
    for number, line in enumerate(ADDRESS.sub(blank, text).splitlines(), 1):
        for match in HASH.finditer(line):
            yield number, f"a commit hash: {match.group(0)}"


def versions(text):
    """(line, name, number of lines) of every version of a changelog."""
    lines = text.splitlines()
    begins = [number for number, line in enumerate(lines) if line.startswith("## ")]
    for begin, end in zip(begins, [*begins[1:], len(lines)]):
        yield begin + 1, lines[begin][3:].strip(), end - begin


def too_long(name, text):
    words, lines = len(re.findall(r"\S*\w\S*", text)), len(text.splitlines())
    if words > MOST_WORDS_OF_PAGE.get(name, words):
        yield 1, f"{words} words, at most {MOST_WORDS_OF_PAGE[name]}"
    if lines > MOST_LINES_OF_PAGE.get(name, lines):
        yield 1, f"{lines} lines, at most {MOST_LINES_OF_PAGE[name]}"
    for line, version, count in versions(text) if name in MOST_LINES_OF_VERSION else ():
        if count > MOST_LINES_OF_VERSION[name]:
            yield line, f"{count} lines of version {version}, at most {MOST_LINES_OF_VERSION[name]}"


def problems(page):
    name, text = page.relative_to(ROOT).as_posix(), page.read_text(encoding="utf-8")
    found = [*too_long(name, text), *long_sentences(text), *long_lines(text), *hashes(text)]
    return [f"{name}:{line}: {what}" for line, what in sorted(found)]


def main():
    asked = [pathlib.Path(name).resolve() for name in sys.argv[1:]] or list(pages())
    found = [problem for page in asked for problem in problems(page)]
    missing = [name for name in (*MOST_WORDS_OF_PAGE, *MOST_LINES_OF_PAGE, *MOST_LINES_OF_VERSION) if not (ROOT / name).exists()]
    found += [f"{name}: not there, but it has a limit" for name in missing]
    print("\n".join(found) if found else f"pages: {len(asked)} can be read")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
