"""What the folder docs/proof holds of the runs of `railpem prove`."""
import csv
import dataclasses
import json
import pathlib

PROOF = pathlib.Path(__file__).resolve().parent.parent / "docs" / "proof"


def rows_of(name):
    with open(PROOF / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@dataclasses.dataclass
class Run:
    name: str
    program: str  # commit, and which trials other commits made
    drawn: str  # which trials of the seed were run
    score: dict
    trials: list

    @property
    def complete(self):
        return self.drawn == "all" and self.score["finished"] == self.score["trials"]

    @property
    def wrong(self):
        return [row for row in self.trials if row["wrong"]]


def runs():
    """Every run, in the order of runs.csv: the order in which they were begun."""
    listed = rows_of("runs.csv")
    names = {row["run"] for row in listed}
    there = {path.name.removesuffix(".score.json") for path in PROOF.glob("*.score.json")}
    if names != there:
        raise ValueError(f"runs.csv and the files *.score.json differ in {', '.join(sorted(names ^ there))}")
    read = lambda name: json.loads((PROOF / f"{name}.score.json").read_text(encoding="utf-8"))
    return [Run(row["run"], row["program"], row["drawn"], read(row["run"]), rows_of(row["run"] + ".trials.csv")) for row in listed]


def latest_complete(all_runs):
    return [run for run in all_runs if run.complete][-1]


def said(row):
    """Verdict, what was named or which names were left, and the first place."""
    names = row["rivals"].replace(" | ", " or ") if row["verdict"] == "ambiguous" else row["named"].replace(" | ", " or ")
    place = f", place {row['first_place']}" if row["verdict"] != "consistent" and row["first_place"] else ""
    return f"`{row['verdict']}`" + (f": {names}" if names else "") + place
