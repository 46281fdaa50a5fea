#!/usr/bin/env python3
"""Fails when two source files of one folder, rooms included, keep the same name to themselves: builds without a compiler
cache compile many of them as one unit.

Constants and types at the beginning of a line count; functions do not, for they may differ in what they take.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OWN = re.compile(r"^(?:(?:static )?(?:constexpr|const) [\w:<>, *&]*?(?P<constant>\w+)(?:\[\w*\])?(?: =|\{|;)|(?:struct|class|enum class|enum|union) (?P<type>\w+)(?:[^;]*\{|\s*:))", re.M)

NAMESPACE = re.compile(r"^namespace (railpem::[\w:]+) \{", re.M)


def folders():
    yield from (build.parent for build in ROOT.glob("*/CMakeLists.txt") if build.parent.name not in ("build", "out", "tests"))
    yield from (path for path in ROOT.glob("tests/*/*") if path.is_dir())


def clashes(folder):
    seen = collections.defaultdict(set)
    for source in folder.rglob("*.cpp"):
        text = source.read_text(encoding="utf-8")
        space = NAMESPACE.search(text)
        for match in OWN.finditer(text):
            seen[(space and space[1], match["constant"] or match["type"])].add(source.relative_to(folder).as_posix())
    return {name: sorted(files) for (_, name), files in seen.items() if len(files) > 1}


def main():
    found = 0
    for folder in sorted(set(folders())):
        for name, files in clashes(folder).items():
            print(f"{folder.relative_to(ROOT)}: {name} is in {', '.join(files)}; give each a name of its own, or put it into a header")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
