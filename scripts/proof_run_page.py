"""The page of one run of `railpem prove`: everything that was counted, and every trial that is wrong."""
from page_text import share, table, written_by
from proof_data import PROOF, said

FIGURES = {"confusion": "what was hidden, and what was said", "detectability": "how strong an effect has to be",
           "calibration": "are the probabilities right", "concealment": "before and after retuning"}


def goal(measure):
    """`at least 98 %`, or nothing where there is none."""
    own = measure.get("goal") or {}
    return next((f"{way.replace('_', ' ')} {100 * value:g} %" for way, value in own.items()), "")


def command(run):
    draw = run.score["settings"]["draw"]
    quick = "--quick " if draw["most_records"] == 1 else ""
    world = draw.get("world", {}).get("grade", "ideal")
    return f"build/release/railpem prove {quick}--trials {run.score['trials']} --seed {draw['seed']} --world {world} --out out/proof"


def measure_rows(score):
    for name, measure in score["measures"].items():
        yield f"`{name}`", measure["says"], share(measure["hits"], measure["of"]), goal(measure)
    yield "`mean_set_size`", "sets returned of trials inside the catalogue in which any was", f"{score['mean_set_size']['value'] or 0:.2f}", "at most 1.3"
    removed = score["held_out_misfit_removed"]
    if removed["trials"]:
        yield ("`held_out_misfit_removed`", "share of the retuned misfit that goes on what no fit has seen, effects rightly named",
               f"{100 * removed['value']:.1f} % of {removed['trials']} trials", "at least 95 %")
    seconds = score["seconds_per_diagnosis"]
    yield ("`seconds_per_diagnosis`", "wall time of one thread, beside whatever else ran",
           f"median {seconds['median']:.0f} s, ninetieth {seconds['ninetieth']:.0f} s, longest {seconds['largest']:.0f} s", "")


def in_words(parameters):
    return ", ".join(f"{name} {value:.3g}" if isinstance(value, float) else f"{name} {value}" for name, value in parameters.items())


def hidden_in_words(own):
    return "; ".join(f"**{one['effect']}** {in_words(one['parameters'])}".strip() for one in own["hidden"]) or "nothing"


def wrong_rows(run):
    hidden = {str(own["trial"]): hidden_in_words(own) for own in run.score["wrong"]}
    for row in sorted(run.wrong, key=lambda own: int(own["trial"])):
        yield row["trial"], hidden[row["trial"]], row["speeds_m_per_s"], said(row), row["retuned_rms_db"], row["wrong"]


def strength_rows(score):
    number = lambda value: "" if value is None else f"{value:.3g}"
    of = lambda own: f"{own['hits']} of {own['of']}"
    for own in score["detectability"]:
        yield own["effect"], f"`{own['parameter']}`" if own["parameter"] else "", of(own["detected"]), of(own["named"]), number(own["smallest_detected"]), number(own["largest_missed"])


def figures(run):
    there = [name for name in FIGURES if (PROOF / run.name / f"{name}.png").exists()]
    return "".join(f"![{FIGURES[name]}](../{run.name}/{name}.png)\n\n" for name in there)


def page(run):
    score, draw = run.score, run.score["settings"]["draw"]
    speeds = "one speed" if draw["most_records"] == 1 else "one to three speeds"
    kinds = ", ".join(f"{kind} {count}" for kind, count in score["kinds"].items())
    return f"""{written_by('scripts/proof_pages.py', run.program)}
# Proof, seed {draw['seed']}, {speeds}: `{run.name}`

{score['finished']} trials; of the seed: {run.drawn}. Hidden: {kinds}. Records of {draw['seconds']:g} s.
[Trials](../{run.name}.trials.csv), [everything counted](../{run.name}.score.json), [what the columns mean](../../../app/prove/README.md).

```sh
{command(run)}
{command(run)} --shard 11/{score['trials']} --keep   # trial 10 alone, with its recordings
```

{table(('measure', 'what is counted', 'measured (95 % interval)', 'goal'), measure_rows(score))}

{figures(run)}## Every wrong or missed trial: {len(run.wrong)} of {score['finished']}

Retuned: rms difference of third-octaves after retuning alone.

{table(('trial', 'hidden', 'speeds, m/s', 'said', 'retuned, dB', 'wrong'), wrong_rows(run))}

## How strong an effect has to be

Trials that hide one thing.

{table(('effect', 'strength', 'detected', 'named', 'smallest detected', 'largest missed'), strength_rows(score))}
"""
