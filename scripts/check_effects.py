#!/usr/bin/env python3
"""Fails when a source outside the folders of effects spells the identifier of one, or when a file of an effect is missing.

An effect is what its files say of it (docs/add_an_effect.md). Whoever needs to know something of an effect asks for that property
of its description, and not for its name. The search and its judges may name effects: some of their rules are about one of them.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MAY_NAME = ("effects/", "diagnosis/effects/", "diagnosis/search/", "diagnosis/judge/", "simulate/effects/", "tests/")
# The same word for something else: what and where.
OTHER_MEANING = {("timing-skew", "recordings/fault.cpp")}  # a fault of a recording, which needs no diagnosis
NOT_OURS = ("build/", "out/")


def identifiers():
    """Identifier of each effect, and whether only `simulate` knows it."""
    found = {}
    for path in sorted((ROOT / "effects/catalogue").glob("*.cpp")):
        text = path.read_text(encoding="utf-8")
        found[path.stem.replace("_", "-")] = ".only_simulated = true" in text
        if f'.id = "{path.stem.replace("_", "-")}"' not in text:
            yield f"effects/catalogue/{path.name}: its identifier is not the name of the file"
        if ".draws =" not in text:
            yield f"effects/catalogue/{path.name}: the proof never draws it"
    for name, only_simulated in found.items():
        for side in ("simulate",) if only_simulated else ("simulate", "diagnosis"):
            if not (ROOT / side / "effects" / f"{name.replace('-', '_')}.cpp").is_file():
                yield f"{name}: no {side}/effects/{name.replace('-', '_')}.cpp"
    yield from spelled_elsewhere(found)


def spelled_elsewhere(names):
    spelled = re.compile(rf"(?<![\w-])(?:{'|'.join(map(re.escape, names))})(?![\w-])")
    for path in sorted(ROOT.rglob("*.[ch]pp")):
        name = path.relative_to(ROOT).as_posix()
        if name.startswith(MAY_NAME + NOT_OURS):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for match in spelled.finditer(line):
                if (match[0], name) not in OTHER_MEANING:
                    yield f"{name}:{number}: {match[0]} is named here; ask for a property of the effect"


def main():
    found = list(identifiers())
    print("\n".join(found) if found else "effects: named in their own files alone, and every one is complete")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
