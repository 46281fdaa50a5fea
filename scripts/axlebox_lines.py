"""Lines of an axle-box record in the domain of wheel turns, each against the broadband level beside it."""
import dataclasses

import numpy as np
from scipy.stats import chi2

from axlebox_recording import RATE_HZ

TURNS = 16                 # per segment: orders are told apart to a sixteenth
NEAREST, FARTHEST = 3, 7   # bins beside a line, on both sides, that make its background
HIGHEST_ORDER = 30         # 200 Hz; above nothing stands out
FALSE_ALARM = 0.01         # of a whole search, over all places and both sides
INDEPENDENT = 0.947        # of Hann segments that overlap by half, per segment
FREE_BINS = 6.9            # independent ones among the ten of the background: Hann bins correlate with their neighbours
ROTATIONS_TRIED = 100      # the rotation was itself found from orders: 1.2 Hz in steps that windows of 4 s tell apart


@dataclasses.dataclass
class Line:
    order: float
    rms: float            # in the unit of the record
    over_db: float        # its bin over the background's
    false_alarm: float    # of a single test
    frequency_hz: float


def segments(x, rotation_hz):
    """Power by segment and sixteenth of an order, and the sum of the window."""
    size = int(round(TURNS * RATE_HZ / rotation_hz))
    # The bins fall on sixteenths to 1/size; at order 30 that is a fiftieth of a bin.
    window = np.hanning(size + 1)[:size]
    starts = range(0, len(x) - size + 1, size // 2)
    return np.array([np.abs(np.fft.rfft(window * x[s : s + size])) ** 2 for s in starts]), window.sum()


def line_at(power, window_sum, bin_, rotation_hz):
    """Every segment's ratio of the bin to its background is by chance beyond r with probability (1 + r/m)^-m; Fisher's sum of their
    logarithms. A segment counts by its ratio, so that one impact does not decide."""
    beside = np.r_[bin_ - FARTHEST : bin_ - NEAREST + 1, bin_ + NEAREST : bin_ + FARTHEST + 1]
    background = power[:, beside].mean(axis=1)
    ratio = power[:, bin_] / background
    logs = FREE_BINS * np.log1p(ratio / FREE_BINS)
    chance = chi2.sf(2.0 * INDEPENDENT * logs.sum(), 2.0 * INDEPENDENT * len(logs))
    weight = background**-2.0  # a segment with an impact knows the line's power less well
    excess = max(0.0, float(np.sum(weight * (power[:, bin_] - background)) / weight.sum()))
    return Line(bin_ / TURNS, float(np.sqrt(2.0 * excess)) / window_sum, float(10 * np.log10(power[:, bin_].mean() / background.mean())), float(chance),
                bin_ / TURNS * rotation_hz)


def spectrum_of_orders(x, rotation_hz):
    power, window_sum = segments(x, rotation_hz)
    places = range(FARTHEST + 1, HIGHEST_ORDER * TURNS + 1)
    return [line_at(power, window_sum, place, rotation_hz) for place in places]


def found(samples, rotation_hz, near=None, tests_more=1):
    """Lines by side that chance alone shows anywhere in the whole search with at most FALSE_ALARM. `near`: only these orders are
    looked at (those that another part of the record has shown)."""
    tests = {side: spectrum_of_orders(x, rotation_hz) for side, x in samples.items()}
    result = {}
    for side, lines in tests.items():
        looked = [line for line in lines if near is None or line.order in near[side]]
        number = tests_more * sum(len(l) if near is None else len(near[s]) for s, l in tests.items())
        good = [line for line in looked if line.false_alarm * number <= FALSE_ALARM]
        # The window spreads a line over its two neighbours: the highest of them is the line.
        by_order = {line.order: line for line in good}
        result[side] = [line for line in good
                        if all(by_order.get(line.order + step / TURNS, line).rms <= line.rms for step in (-2, -1, 1, 2))]
    return result, tests


def is_whole(order):
    return abs(order - round(order)) < 0.5 / TURNS


def on_comb(order, base, reach):
    """Whether an order is a multiple of a base order (supports, joints), within `reach` orders; no whole order."""
    return not is_whole(order) and round(order / base) >= 1 and abs(order - base * round(order / base)) <= reach
