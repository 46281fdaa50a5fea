"""Third-octaves of axle-box records: levels with their scatter, shares of what excites, and whether a shape keeps its frequency or its wavelength."""
import numpy as np
from scipy.ndimage import uniform_filter1d
from scipy.signal import welch
from scipy.stats import t as student

from axlebox_lines import is_whole
from axlebox_recording import RATE_HZ

CENTRES_HZ = 10.0 ** (np.arange(10, 30) / 10.0)  # 10 to 800 Hz
BLOCK_S = 2.75            # blocks of 51 m, taken as independent: eight in the seen part, four in the unseen
SHORT_S = 0.25            # blocks of 4.7 m, for what is there at some places only
LOCAL = 3.0               # power beyond so many times the median of the short blocks belongs to a place
LOCAL_FROM_HZ = 40.0      # below, short blocks hold too few waves: they scatter by themselves
FALSE_ALARM = 0.01        # over all bands and both sides


def edges(centre):
    return centre * 10.0**-0.05, centre * 10.0**0.05


def nominal(centre):
    """The name of a third-octave."""
    names = (10, 12.5, 16, 20, 25, 31.5, 40, 50, 63, 80, 100, 125, 160, 200, 250, 315, 400, 500, 630, 800)
    return f"{names[int(np.argmin(np.abs(np.log(np.array(names) / centre))))]:g}"


def block_powers(x, block_s):
    """Mean square by block and third-octave."""
    size = int(block_s * RATE_HZ)
    rows = []
    for first in range(0, len(x) - size + 1, size):
        spectrum = np.abs(np.fft.rfft(x[first : first + size])) ** 2 * 2.0 / size**2
        f = np.fft.rfftfreq(size, 1.0 / RATE_HZ)
        rows.append([spectrum[(f >= edges(c)[0]) & (f < edges(c)[1])].sum() for c in CENTRES_HZ])
    return np.array(rows)


def levels(x):
    """Mean level in dB by third-octave, its standard error and the number of blocks. Levels are averaged, not powers: one impact moves a
    mean of powers by itself."""
    logs = 10.0 * np.log10(block_powers(x, BLOCK_S))
    return logs.mean(axis=0), logs.std(axis=0, ddof=1) / np.sqrt(len(logs)), len(logs)


def differences(first, second, tests):
    """Level of the second over the first by third-octave: dB, half of a 90 % interval, probability by chance (Welch's t), over all `tests`."""
    (a, ea, na), (b, eb, nb) = levels(first), levels(second)
    error = np.hypot(ea, eb)
    freedom = error**4 / (ea**4 / (na - 1) + eb**4 / (nb - 1))
    return b - a, student.ppf(0.95, freedom) * error, np.minimum(1.0, tests * 2.0 * student.sf(np.abs(b - a) / error, freedom))


def shares(x, lines, support_order):
    """Mean square by third-octave of wheels, supports, single places and the steady rest. They sum up to the whole."""
    total = block_powers(x, len(x) / RATE_HZ)[0]
    parts = {"wheel": np.zeros_like(total), "supports": np.zeros_like(total)}
    for line in lines:
        kind = "wheel" if is_whole(line.order) else "supports" if support_order and on_support(line, support_order) else None
        inside = [edges(c)[0] <= line.frequency_hz < edges(c)[1] for c in CENTRES_HZ]
        if kind:
            parts[kind] += np.array(inside) * line.rms**2
    local = total * np.maximum(0.0, local_share(x) - local_share(np.random.default_rng(1).standard_normal(len(x))))
    parts["places"] = np.minimum(local, np.maximum(total - parts["wheel"] - parts["supports"], 0.0))
    parts["steady"] = np.maximum(total - sum(parts.values()), 0.0)
    return parts


def local_share(x):
    """Share of the mean square beyond LOCAL medians of short blocks, by third-octave."""
    short = block_powers(x, SHORT_S)
    beyond = np.maximum(short - LOCAL * np.median(short, axis=0), 0.0)
    return beyond.sum(axis=0) / np.maximum(short.sum(axis=0), 1e-30) * (CENTRES_HZ >= 0.99 * LOCAL_FROM_HZ)


def on_support(line, support_order):
    return abs(line.order - support_order * max(1, round(line.order / support_order))) < 0.1


def ripples(x, low_hz, high_hz, window_s):
    """The logarithm of the spectrum over log frequency without its slow course over a third of an octave: peaks and dips."""
    f, p = welch(x, RATE_HZ, nperseg=int(window_s * RATE_HZ))
    grid = np.arange(np.log(low_hz) - 0.03, np.log(high_hz) + 0.03, 2e-4)
    course = np.interp(grid, np.log(f[1:]), np.log(p[1:]))
    course -= uniform_filter1d(course, int(0.23 / 2e-4), mode="nearest")
    return course[(grid > np.log(low_hz)) & (grid < np.log(high_hz))]


def stretch(first, second, low_hz, high_hz, window_s, most=0.02):
    """How far the ripples of the second spectrum lie above the first's, relative, and their correlation there."""
    a, b = ripples(first, low_hz, high_hz, window_s), ripples(second, low_hz, high_hz, window_s)
    reach = int(most / 2e-4)
    steps = np.arange(-reach, reach + 1)
    inner = slice(reach, len(a) - reach)
    scores = [np.corrcoef(a[inner], np.roll(b, -s)[inner])[0, 1] for s in steps]
    best = int(np.argmax(scores))
    return steps[best] * 2e-4, scores[best]


def stretch_with_error(first, second, low_hz, high_hz, window_s, parts=8):
    """The same with a standard error from leaving out an eighth of both records after the other."""
    value, score = stretch(first, second, low_hz, high_hz, window_s)

    def left_out(x, i):
        size = len(x) // parts
        return np.concatenate([x[: i * size], x[(i + 1) * size :]])

    others = np.array([stretch(left_out(first, i), left_out(second, i), low_hz, high_hz, window_s)[0] for i in range(parts)])
    return value, float(np.sqrt((parts - 1) / parts * np.sum((others - others.mean()) ** 2))), score
