#!/usr/bin/env python3
"""Fails when a folder includes another that it may not know, or when a folder has no README.

The permitted directions are the house plan of CONTRIBUTING.md. `simulate` may see the parameter structs of
track and vehicle and the formulas of spectra, but none of their solvers.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

PERMITTED = {
    "parameters": set(),
    "lanes": set(),
    "spectra": {"parameters"},
    "vehicle": {"parameters", "lanes"},
    "track": {"parameters", "lanes"},
    "pem": {"parameters", "lanes", "spectra", "vehicle", "track"},
    "simulate": {"parameters", "spectra", "vehicle", "track", "pem"},
    "recordings": {"parameters", "spectra"},
    "diagnosis": {"parameters", "lanes", "spectra", "vehicle", "track", "pem", "recordings"},
    "ranks": set(),
    "app": {"parameters", "lanes", "spectra", "vehicle", "track", "pem", "simulate", "recordings", "diagnosis", "ranks"},
    "python": {"parameters", "pem", "track", "simulate", "recordings", "diagnosis", "app"},
}
# What simulate may open in the folders of the frequency domain: data and closed formulas only.
SIMULATE_MAY_OPEN = re.compile(r"^(parameters/|.*_parameters\.hpp$|spectra/irregularity_spectrum\.hpp$)")
# Libraries that only one folder may touch.
ONLY_IN = {"toml++": "app", "CLI/": "app", "mpi.h": "ranks", "pybind11/": "python"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def problems():
    for folder, permitted in PERMITTED.items():
        base = ROOT / folder
        if not base.is_dir():
            continue
        if not (base / "README.md").is_file():
            yield f"{folder}: no README.md"
        for path in sorted(base.rglob("*.[ch]pp")):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                target = match.group(1)
                where = f"{path.relative_to(ROOT)}:{number}"
                for library, owner in ONLY_IN.items():
                    if target.startswith(library) and folder != owner:
                        yield f"{where}: only {owner} may include <{target}>"
                other = target.split("/")[0]
                if other not in PERMITTED or other == folder:
                    continue
                if other not in permitted:
                    yield f"{where}: {folder} may not include {target}"
                elif folder == "simulate" and not SIMULATE_MAY_OPEN.match(target):
                    yield f"{where}: simulate shares parameter structs only, not {target}"


def main():
    found = list(problems())
    print("\n".join(found) if found else "layers: every include runs in a permitted direction")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
