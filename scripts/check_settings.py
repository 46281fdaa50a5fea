#!/usr/bin/env python3
"""Fails when a number that steers the diagnosis stands anywhere but in the settings of its room.

In the rooms below, a constant of arithmetic type (constexpr, at whatever scope) belongs into the room's settings header,
unless it is a fact of mathematics or of the machine and listed here with the reason. Every member of the settings says
where its number comes from: derived, calibrated, judged, stated elsewhere, or chosen.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent / "diagnosis"
ROOMS = ("expectation", "observations", "likelihood", "fit")
SETTINGS = ("expectation/expectation_settings.hpp", "observations/observation_options.hpp", "model/beliefs.hpp",
            "likelihood/likelihood_settings.hpp", "fit/fit_settings.hpp")
FACTS = {
    "expectation/delay_phases.hpp kAnew": "rounding: so many of them are some 1e-15",
    "expectation/kernel_smoothing.cpp kLanes": "of the processor's vectors",
    "expectation/kernel_smoothing.cpp width": "of the processor's vectors",
    "expectation/source_spectra.cpp kNodes": "Gauss-Hermite rule",
    "expectation/source_spectra.cpp kWeights": "Gauss-Hermite rule",
    "observations/observation.hpp kMostChannels": "matrices live in registers and on the stack",
    "likelihood/split_matrix.hpp kVector": "rows of the processor's vectors",
    "likelihood/split_matrix.cpp kLeastProduct": "two such numbers stay far from underflow",
    "likelihood/whitened_columns.hpp kLane": "unknowns side by side in the processor's vectors",
    "likelihood/whitened_columns.hpp kBins": "a block of them stays in the cache",
    "likelihood/repeated_misfit.cpp kNormalPerMad": "normal deviations in a median absolute deviation",
    "fit/interval.hpp kNinety": "deviations in which 90 % of a Gaussian lie",
    "fit/robust_covariance.cpp kThirdOctave": "2^(1/3)",
    "fit/climb.hpp kNoRival": "stands for a log-posterior that there is none of",
    "fit/fit.cpp kNever": "minus infinity",
}
COMMENT = re.compile(r"//.*")
CONSTANT = re.compile(r"(?<!if )\b(?:constexpr|static const)\s+(?:static\s+)?(?:inline\s+)?(?:const\s+)?"
                      r"(?:double|float|int|long|unsigned|bool|auto|std::(?:size_t|ptrdiff_t|u?int\d+_t|array\s*<[^;=]*?>))"
                      r"(?:\s+(?:int|long))?\s+(?P<names>\w+[^;(]*?[={][^;]*);")
NAME = re.compile(r"(?:^|,\s*)([A-Za-z_]\w*)(?:\[[^\]]*\])?\s*(?=[={])")
MEMBER = re.compile(r"^    (?:double|int|long|std::\S.*?) (?P<name>\w+)\s*(?:=|\{).*")
ORIGIN = re.compile(r"\b(?:derived|calibrated|judged|chosen|stated|EN \d+|k\w*Settings\.\w+)\b", re.I)


def constants(path):
    text = "\n".join(COMMENT.sub("", line) for line in path.read_text(encoding="utf-8").splitlines())
    for match in CONSTANT.finditer(text):
        for name in NAME.findall(match["names"]):
            yield name


def scattered():
    used = set()
    for room in ROOMS:
        for path in sorted((ROOT / room).glob("*.[ch]pp")):
            own = path.relative_to(ROOT).as_posix()
            if own in SETTINGS:
                continue
            for name in constants(path):
                used.add(f"{own} {name}")
                if f"{own} {name}" not in FACTS:
                    yield f"diagnosis/{own}: {name} steers the diagnosis: it belongs into the settings of {room}"
    for fact in sorted(set(FACTS) - used):
        yield f"scripts/check_settings.py: {fact} is listed as a fact, but is no longer there"


def without_origin():
    for settings in SETTINGS:
        comment = ""
        lines = (ROOT / settings).read_text(encoding="utf-8").splitlines()
        for i, line in enumerate(lines):
            stripped = line.strip()
            if stripped.startswith("///"):
                comment += " " + stripped
                continue
            match = MEMBER.match(line)
            if match:
                end = i
                while ";" not in COMMENT.sub("", lines[end]):
                    end += 1
                if not ORIGIN.search(comment + " ".join(lines[i:end + 1])):
                    yield f"diagnosis/{settings}:{i + 1}: {match['name']} does not say where its number comes from"
            comment = ""


def main():
    found = [*scattered(), *without_origin()]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
