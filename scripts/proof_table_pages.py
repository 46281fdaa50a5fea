"""Pages of the tables beside the runs of `railpem prove`: nothing hidden, effect by effect, smallest strengths, wrong physics, friction."""
import statistics

from hide_and_seek import OUTSIDE
from page_text import share, table, written_by
from proof_data import rows_of, said

WRITTEN = "scripts/proof_pages.py"


def latest(rows):
    """The last line of every thing hidden with every seed: lines are added when the program has changed, none is taken away."""
    return list({(row["hidden"], row["seed"]): row for row in rows}.values())


def by(rows, column):
    groups = {}
    for row in rows:
        groups.setdefault(row[column], []).append(row)
    return groups


def complete_seed(rows):
    """Lines of the seed begun last with which everything was hidden that was ever hidden; the last of each."""
    every = {row["hidden"] for row in rows}
    return [latest(own) for own in by(rows, "seed").values() if {row["hidden"] for row in own} == every][-1]


def added(rows, column):
    return sum(int(row[column] or 0) for row in rows)


def right(rows):
    return added(rows, "set_right")


def inside(rows, what):
    return share(added(rows, what + "_right"), added(rows, what))


def programs(rows):
    return ", ".join(dict.fromkeys(row["program"] for row in rows))


def seconds(rows):
    used = [float(row["cpu_s"]) for row in rows if row["cpu_s"]]
    return f"{statistics.median(used):.0f}, {max(used):.0f}" if used else ""


# --- marched, nothing hidden -----------------------------------------------------------------------------------------------


def marched_nulls():
    rows = rows_of("marched_nulls.csv")
    groups = by(rows, "program").items()
    of = lambda own: " to ".join(dict.fromkeys((min(row["seed"] for row in own), max(row["seed"] for row in own))))
    summary = [(program, of(own), share(right(own), len(own)), inside(own, "numbers"), seconds(own)) for program, own in groups]
    wrong = [(row["seed"], row["program"], said(row), row["retuned_rms_db"]) for row in rows if row["set_right"] == "0"]
    return f"""{written_by(WRITTEN)}
# Nothing hidden, marched

Three runs of 60 s at 15, 22.2 and 33 m/s, nine channels, every believed number off within its tolerance. Right is `consistent`.
Numbers are drawn evenly within their tolerances, where the fit believes a Gaussian with the tolerance as deviation: its intervals are
too wide for such truths. Seeds 8401 to 8430 are drawn as the fit believes them (`--numbers believed`).

```sh
scripts/hide_and_seek.py build/release/railpem docs/proof/marched_nulls.csv --effects nothing --trials 30 --first-seed 8301
```

{table(('program', 'seeds', '`consistent` (95 % interval)', 'numbers in their 90 % intervals', 'processor, s: median, longest'), summary)}

## Every wrong line

{table(('seed', 'program', 'said', 'retuned, dB'), wrong)}
"""


# --- marched, effect by effect ---------------------------------------------------------------------------------------------


def effect_row(row):
    verdict = "right" if row["set_right"] == "1" else "wrong"
    of = f"{row['intervals_right']} of {row['intervals']}" if row["intervals"] != "0" else ""
    return row["hidden"], said(row), verdict, row["truth"], row["found"], of, f"{row['numbers_right']} of {row['numbers']}", row["held_out_gain_nats_per_s"], row["cpu_s"]


def seed_row(seed, rows):
    last = latest(rows)
    known, unknown = ([row for row in last if (row["hidden"] in OUTSIDE) == which] for which in (False, True))
    of = lambda own: f"{right(own)} of {len(own)}" if own else ""
    return seed, programs(last), of(known), of(unknown), inside(known, "intervals"), inside(last, "numbers"), seconds(last)


def marched_three_speeds():
    rows = rows_of("marched_three_speeds.csv")
    last = complete_seed(rows)
    wrong = [(row["seed"], row["hidden"], said(row), row["truth"], row["program"]) for row in latest(rows) if row["set_right"] == "0"]
    return f"""{written_by(WRITTEN, programs(last))}
# Effect by effect, marched at three speeds

Three runs of 60 s at 15, 22.2 and 33 m/s, nine channels, every believed number off within its tolerance. Hidden is each effect of the
catalogue that the case can have, at a strength that synthesised records show, or something that only the simulator has (the seven last).
Right is the name, and for what only the simulator has `unexplained` with the place where it sits in front.
The gain on what no fit has seen is against the case that the verdict is held against. Of lines made again the last counts.

```sh
scripts/hide_and_seek.py build/release/railpem docs/proof/marched_three_speeds.csv --trials 1 --first-seed {last[0]['seed']}
```

## The last seed with which everything was hidden: {last[0]['seed']}

{table(('hidden', 'said', '', 'truth', 'found', 'intervals', 'numbers', 'unseen, nats/s', 'processor, s'), map(effect_row, sorted(last, key=lambda row: row['hidden'] in OUTSIDE)))}

## Every seed

{table(('seed', 'program', 'catalogue right', 'outside right', '90 % intervals of effects', 'of numbers', 'processor, s: median, longest'),
       (seed_row(seed, own) for seed, own in by(rows, 'seed').items()))}

## Every wrong line

{table(('seed', 'hidden', 'said', 'truth', 'program'), wrong)}
"""


# --- synthesised -----------------------------------------------------------------------------------------------------------


def synthesised_nulls():
    rows, intervals = rows_of("synthesised_nulls.csv"), rows_of("synthesised_intervals.csv")
    quiet = [row for row in rows if row["verdict"] == "consistent"]
    others = [(row["seed"], f"`{row['verdict']}`: {row['named']}", row["best_score_gain_nats"], row["best_free_correction_nats"]) for row in rows if row not in quiet]
    measured = [
        ("`consistent`", share(len(quiet), len(rows))),
        ("most that anything gained where `consistent`, nats", f"{max(float(row['best_score_gain_nats']) for row in quiet):g}"),
        ("highest score statistic of a free correction where `consistent`, nats (12 withhold a verdict)", f"{max(float(row['best_free_correction_nats']) for row in quiet):.1f}"),
        ("numbers in their 90 % intervals", share(added(intervals, "numbers_in_90_percent"), added(intervals, "numbers"))),
        ("trials with all of their numbers in them", f"{sum(row['numbers'] == row['numbers_in_90_percent'] for row in intervals)} of {len(intervals)}")]
    return f"""{written_by(WRITTEN, '60bdd89 (intervals: 92268d5)')}
# Nothing hidden, drawn from the expectation

Three runs of 60 s, nine channels, drawn from what the estimator expects (complex Wishart). Every number, every wavelength of the
irregularity, the speeds and the width of their lines are drawn as the beliefs have them. These runs carry the thresholds of the verdict.
The fourteen numbers of a trial are right or wrong together: their common scale is known from the beliefs alone.

```sh
build/release/tests/calibrate_verdict cases/wei2016/case1.toml 9501 150 60 0 15 22.2222 33
build/release/tests/calibrate_verdict --numbers cases/wei2016/case1.toml 9501 150 60 0 15 22.2222 33
```

{table(('', 'measured (95 % interval)'), measured)}

## Every other verdict

A stated speed that is too far off is refused before a diagnosis; drawn spectra cannot show that.

{table(('seed', 'said', 'gain, nats', 'free correction, nats'), others)}
"""


def smallest_strengths():
    rows = rows_of("smallest_strengths.csv")
    conditions = list(by(rows, "recordings"))
    cell = lambda row: f"{float(row['lead_at_typical_nats']):.0f}; {row['smallest'] or '–'}" if row else ""
    body = []
    for effect, own in by(rows, "effect").items():
        asked = {row["recordings"]: row for row in own}
        body.append((effect, *(cell(asked.get(condition)) for condition in conditions)))
    return f"""{written_by(WRITTEN)}
# From which strength on an effect shows

The log-evidence by which an effect of typical strength leads the retuned case, in nats; then the smallest strength that leads by the
5 nats that a name needs. Records of 60 s with nine channels are what the case with the effect predicts, without scatter; one speed is
80 km/h, three are 15, 22.2 and 33 m/s. A dash: not within the range of its physics, or an effect without a strength.
An empty cell was not asked.

```sh
build/release/tests/smallest_strengths cases/wei2016/case1.toml 60
```

{table(('effect', *conditions), body)}
"""


def shares_of_effects(rows):
    """Share of the right gain that the best wrong physics reaches, by effect that shows: the median over the effect's variants."""
    shown = [row for row in rows if float(row["right_nats"]) >= 5.0]
    return {effect: statistics.median(float(row["share"]) for row in own) for effect, own in by(shown, "hidden").items()}


def wrong_physics():
    equal, without = rows_of("wrong_physics_synthesised.csv"), rows_of("wrong_physics.csv")
    shares = sorted(shares_of_effects(equal).values())
    explained = sum(row["verdict_without"] in ("explained", "recording-fault") for row in without)
    percent = lambda row: f"{100 * float(row['share']):.1f} %" if float(row["right_nats"]) >= 5.0 else "does not show"
    of_equal = [(row["hidden"], row["right_nats"], row["wrong_of_equal_freedom"], row["wrong_nats"], percent(row)) for row in equal]
    of_search = [(row["hidden"], row["right_nats"], f"`{row['verdict_without']}`", row["wrong"] or "nothing", row["wrong_nats"]) for row in without]
    return f"""{written_by(WRITTEN, '8e02fbd (without the right effect: e790731)')}
# What wrong physics gains on data that no fit has seen

## Of equal freedom

Three runs of a minute, nine channels, drawn from the case with an effect of typical strength and numbers off as they are believed. The
right effect, and the eight others of no more parameters with the highest score statistic, are fitted to three quarters. Counted are the nats
over retuning on the last quarter. The best wrong one gains {100 * statistics.median(shares):.0f} % of the right one in the median of {len(shares)} effects,
{100 * shares[-1]:.0f} % at most.

```sh
build/release/tests/wrong_physics cases/wei2016/case1.toml 60 41 > docs/proof/wrong_physics_synthesised.csv
```

{table(('hidden', 'right, nats', 'best wrong', 'nats', 'share'), of_equal)}

## Without the right effect in the catalogue

Marched recordings diagnosed with the right effect taken out (`--without`), so that the search may bring any set of the others.
`explained` without it: {explained} of {len(without)}. Nats of what the search kept; 0 says that it kept nothing that gains.

```sh
scripts/wrong_physics.py build/release/railpem docs/proof/wrong_physics.csv
```

{table(('hidden', 'right, nats', 'without it', 'kept', 'nats'), of_search)}
"""


def sticks(row):
    return row["hidden"].startswith("sticks")


def friction_laws():
    rows = rows_of("friction_laws.csv")
    body = [(row["hidden"], row["speeds_m_per_s"], said(row | {"rivals": row["named"]}), row["force_n"], row["power"], row["deviation"], row["expected"], row["program"]) for row in rows]
    of_sticking, of_constant = ([row for row in rows if sticks(row) == which] for which in (True, False))
    return f"""{written_by(WRITTEN)}
# Friction that is constant, and friction that sticks

Marched records of friction in one stage, other vehicles, a smoother track, one to three speeds; and of a guidance that holds 1.4 to 2 times
as much at rest as it slides with, which only the simulator has. Of {len(of_sticking)} that stick
{sum(row['verdict'] == 'unexplained' for row in of_sticking)} are `unexplained`; of {len(of_constant)} constant forces
{sum(row['verdict'] == 'explained' for row in of_constant)} are `explained`.
Power: of the forces that friction has beside its damping, in multiples of a constant force's where velocities are Gaussian, with its deviation;
expected: what a constant force would seem to have ([theory](../../theory/diagnosis.md)).

```sh
scripts/friction_laws.py build/release/railpem docs/proof/friction_laws.csv
```

{table(('hidden (N, at rest over sliding)', 'speeds, m/s', 'said', 'found, N', 'power', 'deviation', 'expected', 'program'), body)}
"""


PAGES = {"marched_nulls": marched_nulls, "marched_three_speeds": marched_three_speeds, "synthesised_nulls": synthesised_nulls,
         "smallest_strengths": smallest_strengths, "wrong_physics": wrong_physics, "friction_laws": friction_laws}
