"""The page of the study of two kilometres of axle-box acceleration."""
import math

import numpy as np

import axlebox_bands as bands
import axlebox_lines as lines
from axlebox_recording import SIDES
from page_text import folded, written_by

NAMES = ("km1", "km2")


def sides_mean(values):
    return float(np.mean(list(values)))


def named(result):
    """What was named, with its fitted values."""
    effects = []
    for effect in result["omitted"]:
        values = [f"{name} {p['value']:.2g} [{p['low']:.2g}, {p['high']:.2g}]" if "low" in p else f"{name} {p['value']}" for name, p in effect["parameters"].items()]
        effects.append(f"`{effect['effect']}` ({', '.join(values)})")
    return " and ".join(effects) if effects else "nothing"


class Answer:
    """Everything found, and the page that says it."""

    def __init__(self, study):
        self.study, self.unseen = study, {}

    # --- figures' numbers -------------------------------------------------------------------------------------------------

    def wheel_orders(self, name, of, side):
        return {round(line.order): line for line in self.lines[name][of][side] if lines.is_whole(line.order)}

    def common_orders(self, side):
        return sorted(set(self.wheel_orders("km1", "seen", side)) & set(self.wheel_orders("km2", "seen", side)))

    def confirmed(self, name):
        """Wheel lines of the seen part, and how many of them the unseen part shows again."""
        seen = sum(len(self.wheel_orders(name, "seen", side)) for side in SIDES)
        return seen, sum(len(self.wheel_orders(name, "unseen", side)) for side in SIDES)

    def unseen_level_db(self, name):
        """rms difference of the lines' levels between seen and unseen."""
        pairs = [(self.wheel_orders(name, "seen", side)[n].rms, line.rms) for side in SIDES for n, line in self.wheel_orders(name, "unseen", side).items()]
        return float(np.sqrt(np.mean([(20.0 * math.log10(b / a)) ** 2 for a, b in pairs])))

    def share(self, name, key):
        return 100.0 * sides_mean(self.shares[name][side][key].sum() / sum(part.sum() for part in self.shares[name][side].values()) for side in SIDES)

    def band_share(self, name, low_hz, high_hz):
        inside = (bands.CENTRES_HZ > low_hz) & (bands.CENTRES_HZ < high_hz)
        return 100.0 * sides_mean(sum(part[inside].sum() for part in s.values()) / sum(part.sum() for part in s.values()) for s in self.shares[name].values())

    def beyond_chance(self, of):
        """Third-octaves that differ beyond chance on both sides."""
        return [i for i in range(len(bands.CENTRES_HZ)) if all(self.differences[of][side][2][i] <= bands.FALSE_ALARM for side in SIDES)]

    def range_db(self, of, places):
        values = [self.differences[of][side][0][i] for side in SIDES for i in places]
        return f"{min(values):.0f} to {max(values):.0f} dB"

    # --- tables ------------------------------------------------------------------------------------------------------------

    def share_table(self):
        rows = ["| share of the mean square, 10 to 900 Hz, seen two thirds | km1 | km2 |", "|---|---|---|"]
        words = {"wheel": "wheels: whole orders of rotation", "supports": "supports: the line of sleeper passing",
                 "places": f"single places: beyond {bands.LOCAL:g} medians of quarter seconds, what noise gives taken off",
                 "steady": "the rest, steady: rail surface through car and track"}
        for key, says in words.items():
            rows.append(f"| {says} | " + " | ".join(f"{self.share(name, key):.2g} %" for name in NAMES) + " |")
        rows.append("| of all, between 45 and 90 Hz | " + " | ".join(f"{self.band_share(name, 45, 90):.0f} %" for name in NAMES) + " |")
        return "\n".join(rows)

    def line_table(self):
        rows = ["| side | orders in both | in km1 only | in km2 only | sharp peaks beside, orders, km1; km2 |", "|---|---|---|---|---|"]
        text = lambda orders: ", ".join(map(str, sorted(orders))) or "none"
        for side in SIDES:
            first, second = set(self.wheel_orders("km1", "seen", side)), set(self.wheel_orders("km2", "seen", side))
            beside = ["; ".join(", ".join(f"{line.order:.2f}" for line in self.lines[name]["seen"][side] if not lines.is_whole(line.order)) or "none" for name in NAMES)]
            rows.append(f"| {side} | {text(first & second)} | {text(first - second)} | {text(second - first)} | {beside[0]} |")
        return "\n".join(rows)

    def stretch_table(self):
        expected = 100.0 * (self.study.rotation["km2"] / self.study.rotation["km1"] - 1.0)
        rows = [f"| band | left: shift, correlation | right | keeps its wavelength: {expected:+.2f} %; keeps its frequency: 0 |", "|---|---|---|---|"]
        for low, high in sorted({key[1:3] for key in self.stretches}):
            own = {side: next(value for key, value in self.stretches.items() if key[:3] == (side, low, high)) for side in SIDES}
            cells = [f"{100 * v:+.2f} ± {100 * e:.2f} %, {c:.2f}" for v, e, c in own.values()]
            rows.append(f"| {low:.0f} to {high:.0f} Hz | {cells[0]} | {cells[1]} | {self.judged(own.values(), expected / 100.0)} |")
        return "\n".join(rows)

    @staticmethod
    def judged(values, expected):
        """By the better known of the two sides."""
        value, error, _ = min(values, key=lambda entry: entry[1])
        error = max(error, 2e-4)
        wave, structure = abs(value - expected) / error <= 3.0, abs(value) / error <= 3.0
        if wave and structure or error > expected:
            return "cannot be told"
        return "wavelength" if wave else "frequency" if structure or abs(value) < abs(value - expected) / 2.0 else "neither"

    def diagnosis_table(self):
        rows = ["| recording | held against | verdict | place | believed, dB | retuned, dB | diagnosed, dB | unseen: believed, dB | retuned, dB | diagnosed, dB | unseen, diagnosed over retuned, nats |",
                "|---|---|---|---|---|---|---|---|---|---|---|"]
        for label, (result, _) in self.diagnoses.items():
            fit = result["fit"]
            keys = ("before", "retuned", "after", "held_out_before", "held_out_retuned", "held_out_after")
            against = "km1's `diagnosed.toml`" if "after" in label else "generic case"
            place = result["places"][0]["element"] if result["places"] else "–"
            nats = result["unseen_s"] * (fit["held_out_after"]["log_likelihood_per_second"] - fit["held_out_retuned"]["log_likelihood_per_second"])
            verdict = result["verdict"] + (" (search cut short)" if result["interrupted"] else "")
            rows.append(f"| {label.split()[0]} | {against} | {verdict} | {place} | " + " | ".join(f"{fit[key]['rms_db']:.1f}" for key in keys) + f" | {nats:.0f} |")
        return "\n".join(rows)

    def unseen_table(self):
        rows = ["| unseen third | believed, dB | retuned, dB | diagnosed, dB | without the mean: believed | retuned | diagnosed |", "|---|---|---|---|---|---|---|"]
        for (name, side), errors in self.unseen.items():
            cells = [f"{errors[model][i]:.1f}" for i in (0, 1) for model in ("believed", "retuned", "diagnosed")]
            rows.append(f"| {name}, {side} | " + " | ".join(cells) + " |")
        return "\n".join(rows)

    def outside(self):
        """Numbers that retuning moved beyond two tolerances, by kilometre."""
        texts = []
        for name in NAMES:
            moved = [f"`{own['key']}` {own['believed']:.3g} → {own['value']:.3g} {own['unit']}" for own in self.diagnoses[name][0]["retuned_numbers"] if own["outside"]]
            texts.append(f"{name}: {'; '.join(moved) if moved else 'none'}")
        return ". ".join(texts)

    def statements(self):
        lines_ = []
        for label, (result, _) in self.diagnoses.items():
            against = "km2 against what km1 ended in" if "after" in label else f"{label} against the generic case"
            lines_.append(f"- **{against}**: {result['verdict']}. {result['statement']}")
        return "\n".join(lines_)

    def fault_text(self):
        return "; ".join(f"{name}: " + ", ".join(sorted({f['kind'] for f in self.faults[name]})) for name in NAMES)

    def support_text(self):
        if not self.support:
            return "No line of sleeper passing (supports of 0.50 to 0.75 m) is beyond chance in either kilometre."
        line, name, side, chance = self.support
        spacing = 2.0 * math.pi * self.study.radius / line.order
        reach = spacing / line.order / (2 * lines.TURNS)
        again = any(abs(own.order - line.order) < 0.1 for own in self.lines[name]["unseen"][side])
        return (f"One line of sleeper passing is beyond chance (p = {chance:.0e} over all spacings of 0.50 to 0.75 m): {line.frequency_hz:.1f} Hz in {name}, {side}: "
                f"a spacing of {spacing:.3f} ± {reach:.3f} m with the wheel's circumference. The unseen third {'shows it again' if again else 'does not show it beyond chance'}.")

    # --- the page ----------------------------------------------------------------------------------------------------------

    def answer_text(self):
        common = sum(len(self.common_orders(side)) for side in SIDES)
        places = self.beyond_chance("seen")
        centres = ", ".join(bands.nominal(bands.CENTRES_HZ[i]) for i in places)
        confirmed = {name: self.confirmed(name) for name in NAMES}
        wave = sorted(self.study.speed("km2") / bands.CENTRES_HZ[i] for i in places)
        first, second, after = (self.diagnoses[label][0] for label in ("km1", "km2", "km2 after km1"))
        return f"""- **Common to both: a wheelset that is not round.** {common} lines (both sides together) are whole multiples of one rotation, {self.study.rotation['km1']:.3f} Hz in km1 and
  {self.study.rotation['km2']:.3f} Hz in km2, between orders {min(min(self.common_orders(s)) for s in SIDES)} and {max(max(self.common_orders(s)) for s in SIDES)}: `wheel-out-of-roundness`, {self.share('km1', 'wheel'):.0f} % of the mean square in km1, {self.share('km2', 'wheel'):.1f} % in km2.
  The unseen thirds show {confirmed['km1'][1]} of {confirmed['km1'][0]} again in km1 and {confirmed['km2'][1]} of {confirmed['km2'][0]} in km2, their levels within {self.unseen_level_db('km1'):.1f} and {self.unseen_level_db('km2'):.1f} dB rms.
- **In km2 only: a band of 45 to 82 Hz**, {self.band_share('km2', 45, 90):.0f} % of its mean square (km1: {self.band_share('km1', 45, 90):.0f} %). The third-octaves {centres} Hz lie {self.range_db('seen', places)} above km1, all others within chance. In the unseen
  third it is {self.range_db('unseen', places)}, and everything else some 5 to 10 dB, because km1 is quiet there. The waves are {wave[0]:.2f} to {wave[-1]:.2f} m long, if it is the rail's surface:
  `rail-corrugation` of long pitch, or a rougher rail under the same resonance of the wheel on the track.
- **In km1 only: places.** {self.share('km1', 'places'):.0f} % of its mean square (km2: {self.share('km2', 'places'):.0f} %) comes in bursts, most of them in its first ten seconds (a switch, joints or bad spots:
  `rail-joints` needs a regular distance and is not named). Its last third is much quieter than what was seen, so it confirms lines and shapes, not levels.
- **The program's verdicts**: km1 {first['verdict']}, km2 {second['verdict']}, km2 against what km1 ended in {after['verdict']}. {self.verdict_note()}
- **Supports say little**: {self.support_text()}"""

    def verdict_note(self):
        """What stands beside the verdicts, and how far the unseen third bears the models out."""
        fit = {label: result["fit"] for label, (result, _) in self.diagnoses.items()}
        beside = [f"{label} {' and '.join('`' + own['effect'] + '`' for own in self.diagnoses[label][0]['omitted']) or 'nothing'}" for label in NAMES]
        return f"""Retuned, the generic case follows the third-octaves of what was seen within {fit['km1']['retuned']['rms_db']:.1f} dB (km1) and {fit['km2']['retuned']['rms_db']:.1f} dB (km2), with numbers that no car has.
  In km2 the unseen third bears it out: {fit['km2']['held_out_before']['rms_db']:.1f} dB believed, {fit['km2']['held_out_retuned']['rms_db']:.1f} retuned, {fit['km2']['held_out_after']['rms_db']:.1f} diagnosed. In km1 its shape does ({self.unseen_mean('km1', 'believed', 1):.1f} dB believed, {self.unseen_mean('km1', 'retuned', 1):.1f} retuned, {self.unseen_mean('km1', 'diagnosed', 1):.1f} diagnosed), its level does not.
  No set of the catalogue explains the rest; beside the verdict stand {', '.join(beside)}, which may stand in for what is missing. They show in the likelihood of the unseen third, not in its third-octaves.
- **What km2 has more than km1, asked of the program**, believing what km1 ended in, and that the same car ran over both. Verdict: {self.diagnoses['km2 after km1'][0]['verdict']}.
  Named: {named(self.diagnoses['km2 after km1'][0])}. {self.of_waves()}"""

    def of_waves(self):
        """In how many of these answers waves are named, how long, and what that means."""
        lengths = [own["parameters"]["wavelength_m"]["value"] for result, _ in self.after_km1.values() for own in result["omitted"] if own["effect"] == "rail-corrugation"]
        if not lengths:
            return "None of that are waves of the rail, which the bands show: what is named stands in for them."
        worst = max(self.after_km1)
        return f"""Waves of the rail are the length of those that the bands show, but not they alone.
  {len(lengths)} of {len(self.after_km1)} answers, for a car known exactly to one known within {100 * worst:g} %, name them, {min(lengths):.2f} to {max(lengths):.2f} m long. What else stands beside them changes from one to the next and is not to be believed."""

    def car_known_table(self):
        """What km2 has more than km1, by how well the car is known."""
        rows = ["| the car's numbers and the contact are known within | verdict | beside it | retuned, dB | diagnosed, dB |", "|---|---|---|---|---|"]
        for tolerance, (result, _) in self.after_km1.items():
            fit = result["fit"]
            rows.append(f"| {100 * tolerance:g} % | {result['verdict']} | {named(result)} | {fit['retuned']['rms_db']:.2f} | {fit['after']['rms_db']:.2f} |")
        return "\n".join(rows)

    def unseen_mean(self, name, model, which):
        return sides_mean(self.unseen[name, side][model][which] for side in SIDES)

    def text(self):
        return folded(f"""{written_by('scripts/diagnose_two_kilometres.py PATH')}
# Two kilometres of axle-box acceleration

One run, presumably one axle, vertical acceleration left and right, 33 s from kilometre 1 and 33 s from kilometre 2; car, track and unit are not stated. The first
two thirds of each are seen by every fit and test, the last third by none.

{self.answer_text()}

![Spectra of both kilometres](two_kilometres_spectra.png)

## Lines: the wheel

![Amplitude of the wheel's orders](two_kilometres_lines.png)

{self.line_table()}

The rotation is followed by the lines themselves: it rises by {100 * (self.study.track['km1'][1].max() / self.study.track['km1'][1].min() - 1):.1f} % along km1 and changes by {100 * (self.study.track['km2'][1].max() / self.study.track['km2'][1].min() - 1):.1f} % along km2. With the speed column (steps of 1 km/h) the wheel's radius is
{self.study.radius:.3f} m, between {self.study.radius_range[0]:.3f} and {self.study.radius_range[1]:.3f}. Some harmonics of sleeper passing fall onto whole orders (the fourth of a 0.6 m spacing on order 19); the wheel has
neighbouring orders of the same size, supports would have their first as well. Peaks beside the whole orders are wider than a line: they belong to the ripple below.

## Shares

![Shares by third-octave and cause](two_kilometres_shares.png)

{self.share_table()}

## What keeps its wavelength, what its frequency

From km1 to km2 the rotation rises by {100 * (self.study.rotation['km2'] / self.study.rotation['km1'] - 1):.2f} %. That is little, but enough for sharp peaks and dips (lines lowered, the slow course of the spectrum taken off):

{self.stretch_table()}

The peaks some 8 Hz apart between 40 and 80 Hz are in both kilometres, and (by the right side) they keep their wavelengths. A rail's surface would hardly repeat itself a kilometre on; the likeliest
is the car's own length: a second wheel of the bogie, {self.study.speed('km2') / 8.5:.1f} to {self.study.speed('km2') / 7.5:.1f} m away, meets the same surface and shakes the first through the rail. The generic case has that coupling, at 2.5 m, far too weak (blue, below):
retuning makes the track nearly undamped to reach it. So the place is likely, the law is not known. The peaks near 475 and 780 Hz do not rise with the speed; they lie half a per cent lower in km2: structure (axle, axle box, rail on its pads). Slow courses, above all the band of 45 to 82 Hz, are too wide for that: rail surface and the resonance of
the wheel on the track cannot be parted by one run at one speed.

## What differs

![Level of km2 over km1](two_kilometres_difference.png)

## The program's diagnosis

![Recorded, believed, retuned, diagnosed](two_kilometres_diagnosed.png)

Against [cases/generic](../../cases/generic/README.md), wheel radius from the lines, scale of every channel free, each side on a rail of its own with one spectrum for both; 2 to 167 Hz; lines brought
down to the level beside them. For the last row km2 is given in the scale that km1 ended in, so that levels count, and the car and its contact are those that km1 ended in within {100 * self.study.same_car:g} %: it is one run.

{self.diagnosis_table()}

{self.statements()}

How much rests on the car being the same:

{self.car_known_table()}

Numbers that retuning moved beyond two of their wide tolerances (what the model needs to follow the record, not what the car has): {self.outside()}.

The whole levels of the unseen third (20 to 150 Hz, third-octaves), and without their mean difference, which the unknown scale and a quieter section share:

{self.unseen_table()}

## What cannot be told

- Levels: the unit is not certain (m/s² or g). Amplitudes of roundness and corrugation in metres would need it.
- Rail surface or resonance: one speed. The same run at half the speed would tell: waves of {self.study.speed('km2') / 75.0:.2f} m would shake at 37 Hz, a resonance stays at 75 Hz.
- Above 167 Hz nothing is compared with the model: its irregularity ends at 0.1 m, its diagnosis at 175 Hz. Shares, lines and differences are given there.
- Two channels of one axle do not fix a car: suspension, bogie and body have hardly any say at an axle box.
- Blocks of {bands.BLOCK_S:g} s are taken as independent for the intervals of levels; 400 m of track are a small sample of a kilometre.
- What `railpem inspect` finds in the records as they came: {self.fault_text()}; the mileage was computed, not measured.

## Method

Every line is tested against the ten bins beside it in segments of {lines.TURNS} turns (Hann, half overlapped). In each the ratio is beyond r by chance with probability
(1 + r/m)^−m, m = {lines.FREE_BINS:g}. The segments are joined by Fisher's sum, with a false alarm of {100 * lines.FALSE_ALARM:g} % over all {lines.HIGHEST_ORDER * lines.TURNS - lines.FARTHEST} places, both sides and {lines.ROTATIONS_TRIED} rotations tried. In the unseen third only orders found before are tested.
`railpem inspect` on the same records (F test of Thomson in sections of 8 s, 1e-4 over all frequencies) finds the strongest of them by itself: {self.inspected_text()}.
Levels are means of eight (unseen: four) blocks in dB, compared by Welch's t over all {2 * len(bands.CENTRES_HZ)} bands and sides. Shifts are where the correlation of log spectra without their course over a third of an octave
is highest; their error by leaving out eighths.

Data: `高速列车轨道波摩检测模型设计/Dataset` of [TiraMisuLab01/AVMD_for_Rail_Corrugation_Detection](https://github.com/TiraMisuLab01/AVMD_for_Rail_Corrugation_Detection)
(GPL-3.0, commit e286d0b, 2025), pieces of 2000 samples put in order of mileage as `km1.csv` and `km2.csv` with the columns `km`, `speed_kmh`, `left`, `right`; they are not in this repository.
""")

    def inspected_text(self):
        texts = []
        for (name, of), sides in self.inspected_lines.items():
            orders = [f"{side} {', '.join(f'{order:.3f}' for order, _ in own)}" for side, own in sides.items() if own]
            texts.append(f"{name}, {of}: {'; '.join(orders) if orders else 'none'}")
        return ". ".join(texts)
