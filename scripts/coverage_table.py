#!/usr/bin/env python3
"""Lines reached by the tests per folder, as a table, from the JSON of gcovr; the lines that were not, to a file.

Usage: coverage_table.py coverage.json uncovered.txt
"""
import collections
import json
import pathlib
import sys


def spans(numbers):
    """1, 2, 3, 7 as "1-3 7"."""
    texts, begin, last = [], None, None
    for number in [*sorted(numbers), None]:
        if last is not None and number != last + 1:
            texts.append(f"{begin}" if begin == last else f"{begin}-{last}")
            begin = None
        if begin is None:
            begin = number
        last = number
    return " ".join(texts)


def main():
    source, listing = map(pathlib.Path, sys.argv[1:3])
    folders = collections.defaultdict(lambda: [0, 0])
    uncovered = []
    for file in json.loads(source.read_text())["files"]:
        lines = {}
        for line in file["lines"]:
            if not line.get("gcovr/noncode", False):
                lines[line["line_number"]] = max(line["count"], lines.get(line["line_number"], 0))
        missed = [number for number, count in lines.items() if count == 0]
        folder = folders[file["file"].split("/")[0]]
        folder[0] += len(lines)
        folder[1] += len(lines) - len(missed)
        if missed:
            uncovered.append(f"{file['file']}: {spans(missed)}")
    listing.write_text("\n".join(uncovered) + "\n")
    print("| folder | lines | reached |\n|---|---|---|")
    for name, (lines, reached) in sorted(folders.items()):
        print(f"| `{name}` | {lines} | {100.0 * reached / lines:.1f} % |")
    lines, reached = (sum(values[i] for values in folders.values()) for i in (0, 1))
    print(f"| all | {lines} | {100.0 * reached / lines:.1f} % |")


if __name__ == "__main__":
    main()
