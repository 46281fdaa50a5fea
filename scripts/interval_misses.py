#!/usr/bin/env python3
"""By how much fitted parameters of effects miss what was hidden in marched recordings, beyond what their intervals leave open.

    scripts/interval_misses.py docs/proof/marched_three_speeds.csv 7301

Reads a table of scripts/hide_and_seek.py from a first seed on. Per parameter: how many, the share that lies in its 90 % interval, the relative misses in per cent, and the
relative deviation that would have to be added to the intervals' own for them to be as large as they are (root of the mean of miss² − deviation², 0 where that is
negative). EffectParameter::inexact in effects/catalogue holds it where it is not 0.
"""
import collections
import csv
import math
import re
import sys

NINETY = 1.645  # deviations of a normal distribution


def effects(text):
    """[(effect, {parameter: text})] of a cell."""
    for part in re.split(r"; (?=[a-z])", text):
        words = part.split(" ")
        if words[0]:
            yield words[0], dict(word.split("=", 1) for word in words[1:] if "=" in word)


def misses_of(row):
    """(effect, parameter), relative miss and relative deviation of everything of a row that was hidden, named and has an interval."""
    truth = dict(effects(row["truth"]))
    for effect, found in effects(row["found"]):
        for name, text in found.items():
            fitted = re.fullmatch(r"([-\d.e+]+)\[([-\d.e+]+),([-\d.e+]+)\]", text)
            try:
                hidden = float(truth[effect][name])
            except (KeyError, ValueError):
                continue
            if fitted and hidden != 0.0:
                value, low, high = map(float, fitted.groups())
                yield (effect, name), value / hidden - 1.0, (high - low) / (2.0 * NINETY * abs(hidden)), low <= hidden <= high


def main():
    table, first = sys.argv[1], int(sys.argv[2])
    found = collections.defaultdict(list)
    with open(table) as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if int(row["seed"]) >= first and row["set_right"] == "1":
                for key, *miss in misses_of(row):
                    found[key].append(miss)
    for (effect, name), own in sorted(found.items()):
        beyond = math.sqrt(max(0.0, sum(miss**2 - deviation**2 for miss, deviation, _ in own) / len(own)))
        print(f"{effect:34s} {name:22s} {sum(inside for *_, inside in own):2d} of {len(own):2d} inside, beyond {100 * beyond:5.2f} %: "
              + " ".join(f"{100 * miss:+.2f}" for miss, *_ in own))


if __name__ == "__main__":
    main()
