#!/usr/bin/env python3
"""Fails when a number that a page states is not what the program gives.

A number is checked where a page has, on a line of its own below the paragraph that states it,

    <!-- check: COMMAND => EXPECTED -->

COMMAND is run by bash in the top folder with the program as `railpem` and an empty folder `$out`; what it prints has to be EXPECTED. Words
have to be the same; a number may be off by half a unit of its last digit as it is written. Every number of EXPECTED has to stand in the
paragraph above, written the same. Keep commands short: all of them together are to take less than ten seconds.

    scripts/check_numbers.py build/release/railpem [PAGE…]
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from check_links import ROOT, pages

CHECK = re.compile(r"^<!-- check: (.*?) => (.*?) -->$")
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
SECONDS = 60


def checks(page):
    """(line, command, expected, paragraph above) of every check of a page."""
    above, blocks = [], [""]
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if match := CHECK.match(line.strip()):
            yield number, match.group(1), match.group(2), " ".join(above or [blocks[-1]])
        elif "<!-- check" in line:
            yield number, None, line.strip(), ""
        elif line.strip():
            above.append(line)
        elif above:
            blocks.append(" ".join(above))
            above = []


def half_a_unit(text):
    mantissa, _, exponent = text.partition("e")
    digits = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - digits)


def agrees(expected, printed):
    if not NUMBER.fullmatch(expected):
        return expected == printed
    try:
        return abs(float(printed) - float(expected)) <= half_a_unit(expected) * (1 + 1e-9)
    except ValueError:
        return False


def problem(command, expected, paragraph, program):
    """What is wrong with a check, or nothing."""
    if command is None:
        return f"not a check: {expected}; allowed: <!-- check: COMMAND => EXPECTED -->"
    for number in filter(NUMBER.fullmatch, expected.split()):
        if not re.search(r"(?<![\d.])" + re.escape(number) + r"(?!\d|\.\d)", paragraph):
            return f"{number} does not stand in the paragraph above"
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "bin").mkdir()
        (pathlib.Path(folder) / "bin" / "railpem").symlink_to(program)
        (pathlib.Path(folder) / "out").mkdir()
        environment = {**os.environ, "LC_ALL": "C", "PATH": f"{folder}/bin:{os.environ['PATH']}", "out": f"{folder}/out"}
        try:
            run = subprocess.run(["bash", "-c", command], cwd=ROOT, env=environment, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return f"took more than {SECONDS} s: {command}"
    if run.returncode != 0:
        return f"failed with {run.returncode}: {command}\n{run.stderr.strip()}"
    wanted, printed = expected.split(), run.stdout.split()
    if len(wanted) != len(printed) or not all(map(agrees, wanted, printed)):
        return f"the page says {' '.join(wanted)}, the program {' '.join(printed)}: {command}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    begin, count, found = time.monotonic(), 0, []
    for page in [path.resolve() for path in arguments.pages] or pages():
        for line, command, expected, paragraph in checks(page):
            count += 1
            if wrong := problem(command, expected, paragraph, arguments.program.resolve()):
                found.append(f"{page.relative_to(ROOT)}:{line}: {wrong}")
    if count == 0:
        found.append("no page has a check: looked in the wrong place")
    print("\n".join(found) if found else f"numbers: {count} checks of pages hold, {time.monotonic() - begin:.1f} s")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
