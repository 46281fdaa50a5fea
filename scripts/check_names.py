#!/usr/bin/env python3
"""Fails when two source files of one folder keep the same name to themselves: builds without a compiler cache compile many of them as one unit.

Constants and types at the beginning of a line count; functions do not, for they may differ in what they take.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OWN = re.compile(r"^(?:(?:static )?(?:constexpr|const) [\w:<>, *&]*?(?P<constant>\w+)(?:\[\w*\])?(?: =|\{|;)|(?:struct|class|enum class|enum|union) (?P<type>\w+)(?:[^;]*\{|\s*:))", re.M)


def folders():
    for build in ROOT.rglob("CMakeLists.txt"):
        if not any(part in ("build", "out") for part in build.relative_to(ROOT).parts):
            yield build.parent
    yield from (path for path in ROOT.glob("tests/*/*") if path.is_dir())


def clashes(folder):
    seen = collections.defaultdict(set)
    for source in folder.glob("*.cpp"):
        for match in OWN.finditer(source.read_text()):
            seen[match["constant"] or match["type"]].add(source.name)
    return {name: sorted(files) for name, files in seen.items() if len(files) > 1}


def main():
    found = 0
    for folder in sorted(set(folders())):
        for name, files in clashes(folder).items():
            print(f"{folder.relative_to(ROOT)}: {name} is in {', '.join(files)}; give each a name of its own, or put it into a header")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
