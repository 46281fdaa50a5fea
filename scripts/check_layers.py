#!/usr/bin/env python3
"""Fails when a folder or a room includes another that it may not know, when two units include each other in a circle,
when a folder holds more source files than a reader can look over, or when a folder has no README.

The permitted directions are the house plan of CONTRIBUTING.md. `simulate` may see the parameter structs of
track and vehicle, the catalogue of effects and the formulas of spectra, but none of their solvers. A room is a folder within a folder; a unit is
a header with the source of the same name.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

PERMITTED = {
    "parameters": set(),
    "lanes": set(),
    "effects": set(),
    "spectra": {"parameters"},
    "vehicle": {"parameters", "lanes"},
    "track": {"parameters", "lanes"},
    "pem": {"parameters", "lanes", "spectra", "vehicle", "track"},
    "simulate": {"parameters", "effects", "spectra", "vehicle", "track", "pem"},
    "recordings": {"parameters", "spectra"},
    "diagnosis": {"parameters", "lanes", "effects", "spectra", "vehicle", "track", "pem", "recordings"},
    "ranks": set(),
    "app": {"parameters", "lanes", "effects", "spectra", "vehicle", "track", "pem", "simulate", "recordings", "diagnosis", "ranks"},
    "python": {"parameters", "pem", "track", "simulate", "recordings", "diagnosis", "app"},
}
# The rooms of a folder, from the ground up: each may know those before it. What lies in the folder itself: "ground" stands
# below all of its rooms, "roof" above them.
ROOMS = {
    "effects": ["ground", "catalogue"],
    "diagnosis": ["effects", "expectation", "observations", "model", "likelihood", "fit", "hypotheses", "judge", "search", "findings",
                  "roof"],
    "track": ["ground", "elements", "pads", "statics", "rail"],
    "pem": ["ground", "rail", "coupling", "lines", "distortion"],
    "simulate": ["numerics", "ground", "track", "vehicle", "march", "effects"],
    "recordings": ["files", "matlab", "text", "ground", "loading", "estimates", "checks", "page", "inspection"],
    "app": ["ground", "schema", "plausibility", "tables", "page", "report", "prove", "verbs"],
}
# Where the program begins, it knows everything.
ABOVE_ALL = {"app/main.cpp"}
MOST_FILES = 40  # of one folder, sources and headers
# What simulate may open in the folders of the frequency domain: data and closed formulas only.
SIMULATE_MAY_OPEN = re.compile(r"^(parameters/|effects/|.*_parameters\.hpp$|spectra/irregularity_spectrum\.hpp$)")
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


def room_of(path):
    """Place of a file among the rooms of its folder; None where they have no order."""
    folder, *rest = path.split("/")
    rooms = ROOMS.get(folder)
    if not rooms:
        return None
    room = rest[0] if len(rest) > 1 else "roof" if "roof" in rooms else "ground"
    return rooms.index(room) if room in rooms else None


def sources():
    for folder in PERMITTED:
        for path in sorted((ROOT / folder).rglob("*.[ch]pp")):
            yield path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")


def rooms_and_circles():
    includes = collections.defaultdict(set)
    for name, text in sources():
        own, unit = room_of(name), name.rsplit(".", 1)[0]
        includes[unit]  # a unit without includes is one, too
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            if not match or match.group(1).split("/")[0] not in PERMITTED:
                continue
            target = match.group(1)
            if target.rsplit(".", 1)[0] != unit:
                includes[unit].add(target.rsplit(".", 1)[0])
            other = room_of(target)
            if target.split("/")[0] == name.split("/")[0] and None not in (own, other) and other > own and name not in ABOVE_ALL:
                yield f"{name}:{number}: a room may not know one above it: {target}"
    for circle in circles(includes):
        yield "units include each other in a circle: " + ", ".join(sorted(circle))


def circles(includes):
    """Strongly connected components of more than one unit (Tarjan 1972)."""
    order, low, stack, found = {}, {}, [], []

    def visit(unit):
        order[unit] = low[unit] = len(order)
        stack.append(unit)
        for other in includes.get(unit, ()):
            if other not in order:
                visit(other)
                low[unit] = min(low[unit], low[other])
            elif other in stack:
                low[unit] = min(low[unit], order[other])
        if low[unit] == order[unit]:
            component = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(component) > 1:
                found.append(component)

    for unit in sorted(includes):
        if unit not in order:
            visit(unit)
    return found


def full_folders():
    files = collections.Counter(name.rsplit("/", 1)[0] for name, _ in sources())
    for folder, count in sorted(files.items()):
        if count > MOST_FILES:
            yield f"{folder}: {count} source files, at most {MOST_FILES}"


def main():
    found = [*problems(), *rooms_and_circles(), *full_folders()]
    print("\n".join(found) if found else "layers: every include runs in a permitted direction, and none in a circle")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
