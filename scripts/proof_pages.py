#!/usr/bin/env python3
"""Writes the pages of docs/proof/runs and the tables of docs/proof/README.md from the tables that are kept there.

    scripts/proof_pages.py            after a run has been added (its score, its trials and a row of docs/proof/runs.csv)
    scripts/proof_pages.py --check    fails where a page is not what the data give

One page per run of `railpem prove` and one per table beside them (proof_run_page, proof_table_pages). The head table is of the last row of
runs.csv whose trials are all finished.
"""
import argparse
import collections
import statistics
import sys

import proof_run_page
import proof_table_pages as tables
from page_text import share, table, with_table
from proof_data import PROOF, latest_complete, rows_of, runs

# (measure, question, what it means to somebody who reads a report, with what was counted of wrong trials in braces)
HEAD = [
    ("nulls_named", "something named where nothing is hidden", "you are not sent after what is not there"),
    ("sensor_named_for_physics", "a sensor named where physics is hidden", "a sound sensor is not blamed"),
    ("physics_named_for_sensor", "physics named where a sensor is at fault", "a bad sensor is not taken for physics"),
    ("detected", "detected of what is hidden, however weak", "the rest, {missed}, is `consistent`"),
    ("right_place", "right place, of what is detected", "where to look first"),
    ("right_place_concealed", "the same where retuning hides the effect", "spectra that agree by eye do not hide the place"),
    ("right_effect", "the named set is what is hidden, where one set is named", "of the others {only one of two named} name one of two, {a wrong name beside a right one} one too many"),
    ("parameter_error_named", "a wrong number found", "numbers two to five tolerances off are retuned without being named"),
    ("pairs_both_named", "both of two effects", "of two effects expect to be told one"),
    ("outside_abstains", "no name for what the catalogue does not have", "unknown physics mostly stays unnamed"),
    ("outside_confident_wrong_name", "a confident wrong name for it", "which: see the page of the run"),
    ("intervals_cover", "90 % intervals of effects that hold the truth", "the stated intervals can be used"),
    ("baseline_retuning_nulls", "for comparison: retuning alone finds fault where nothing is hidden", "the usual way cries wolf"),
    ("baseline_bic_detected", "for comparison: BIC on the spectra detects", "coherence and phases find more"),
]


def status(measure):
    """Whether a goal is met, and whether the 95 % interval says so too."""
    own = measure.get("goal") or {}
    for way, worst in (("at_least", measure["low"]), ("at_most", measure["high"])):
        if way in own:
            holds = (lambda value: value >= own[way]) if way == "at_least" else (lambda value: value <= own[way])
            return f"{proof_run_page.goal(measure)}: " + ("**missed**" if not holds(measure["value"]) else "met" if holds(worst) else "met, not proven")
    return ""


def head_table(run):
    measures = run.score["measures"]
    counts = collections.defaultdict(int, run.score["wrong_counts"])
    rows = [(question, status(measures[name]), share(measures[name]["hits"], measures[name]["of"]), means.format_map(counts)) for name, question, means in HEAD]
    removed, seconds = run.score["held_out_misfit_removed"], run.score["seconds_per_diagnosis"]
    rows.append(("misfit removed on what no fit has seen", "at least 95 %: " + ("met" if removed["value"] >= 0.95 else "**missed**"),
                 f"{100 * removed['value']:.1f} % of {removed['trials']} rightly named", "a right name predicts"))
    rows.append(("time of a diagnosis, one thread", "", f"median {seconds['median']:.0f} s, ninetieth {seconds['ninetieth']:.0f} s", "[how fast today](../speed.md)"))
    return table(("", "goal", "measured (95 % interval)", "what it means"), rows)


def page_link(name):
    return f"[{name}](runs/{name}.md)"


def evidence_table():
    """What the tables beside the runs say, one line each."""
    nulls, effects, drawn = rows_of("marched_nulls.csv"), rows_of("marched_three_speeds.csv"), rows_of("synthesised_nulls.csv")
    last = tables.complete_seed(effects)
    inside, outside = ([row for row in last if (row["hidden"] in tables.OUTSIDE) == which] for which in (False, True))
    shares = tables.shares_of_effects(rows_of("wrong_physics_synthesised.csv")).values()
    without = rows_of("wrong_physics.csv")
    friction = rows_of("friction_laws.csv")
    sticking = [row for row in friction if tables.sticks(row)]
    explained = lambda rows, column: sum(row[column] in ("explained", "recording-fault") for row in rows)
    last_nulls = tables.latest(nulls)
    rows = [
        ("nothing hidden, drawn from the expectation", f"{share(sum(row['verdict'] == 'consistent' for row in drawn), len(drawn))} `consistent`", page_link("synthesised_nulls")),
        ("nothing hidden, marched; last line of each seed", f"{share(tables.right(last_nulls), len(last_nulls))} `consistent`", page_link("marched_nulls")),
        ("each effect of the catalogue at three speeds", f"{tables.right(inside)} of {len(inside)} named", page_link("marched_three_speeds")),
        ("each thing that only the simulator has", f"{tables.right(outside)} of {len(outside)} `unexplained` in their place", "the same"),
        ("smallest strength that shows", "a table", page_link("smallest_strengths")),
        ("best wrong physics of equal freedom, unseen data", f"{100 * statistics.median(shares):.0f} % of the right gain in the median, {100 * max(shares):.0f} % at most", page_link("wrong_physics")),
        ("the right effect taken out of the catalogue", f"{explained(without, 'verdict_without')} of {len(without)} `explained`", "the same"),
        ("friction that sticks", f"{explained(sticking, 'verdict')} of {len(sticking)} called constant friction", page_link("friction_laws"))]
    return table(("what was tried", "result", "page"), rows)


def confident_wrong(run):
    own = run.score["measures"]["outside_confident_wrong_name"]
    return f"{own['hits']} of {own['of']}" if own["of"] else ""


def runs_table(all_runs):
    rows = [(page_link(run.name), run.drawn, len(run.wrong), confident_wrong(run)) for run in reversed(all_runs)]
    return table(("run, latest first", "trials", "wrong or missed", "outside: confident wrong names"), rows)


def pages():
    """Every page by its path, as the data give it."""
    all_runs = runs()
    found = {PROOF / "runs" / f"{run.name}.md": proof_run_page.page(run) for run in all_runs}
    found |= {PROOF / "runs" / f"{name}.md": text() for name, text in tables.PAGES.items()}
    readme = (PROOF / "README.md").read_text(encoding="utf-8")
    last = latest_complete(all_runs)
    for name, body in (("latest complete run", head_table(last)), ("beside the runs", evidence_table()), ("all runs", runs_table(all_runs))):
        readme = with_table(readme, name, body)
    if f"runs/{last.name}.md" not in readme or f"{last.name}/confusion.png" not in readme:
        raise ValueError(f"README.md has to show page and confusion figure of {last.name}")
    return found | {PROOF / "README.md": readme}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    wanted, stale = pages(), []
    for path in sorted((PROOF / "runs").glob("*.md")):
        if path not in wanted:
            stale.append(f"{path.name}: no data give this page")
    for path, text in wanted.items():
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            stale.append(f"{path.name}: is not what the data give; run scripts/proof_pages.py")
            if not arguments.check:
                path.parent.mkdir(exist_ok=True)
                path.write_text(text, encoding="utf-8")
    if arguments.check:
        print("\n".join(stale) if stale else f"proof: {len(wanted)} pages are what the data give")
        return 1 if stale else 0
    print(f"{len(stale)} of {len(wanted)} pages written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
