"""Axle-box records of one run: read, followed in speed by the wheel itself, written as recordings that the program reads."""
import csv
import math
import pathlib

import numpy as np
from scipy.ndimage import median_filter

RATE_HZ = 2000.0
SIDES = ("left", "right")
SEEN = 2.0 / 3.0               # of every record; what follows is the unseen third
ROTATION_HZ = (6.0, 7.2)       # wheels of 0.42 to 0.50 m radius at 67 to 68 km/h
TRACKED_ORDERS = range(11, 24)  # the orders that stand out at any speed near that of the run


class Kilometre:
    """Accelerations by side without their mean (the unit is not certain), the speed as stated, and the mileage."""

    def __init__(self, path):
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        self.name = pathlib.Path(path).stem
        self.mileage_km = np.array([float(row["km"]) for row in rows])
        self.speed_m_per_s = np.array([float(row["speed_kmh"]) / 3.6 for row in rows])
        self.offset = {side: float(np.mean([float(row[side]) for row in rows])) for side in SIDES}
        self.samples = {side: np.array([float(row[side]) for row in rows]) - self.offset[side] for side in SIDES}

    def duration_s(self):
        return len(self.mileage_km) / RATE_HZ


def rotation_along(samples, window_s=4.0, hop_s=0.5):
    """(time, rotation in Hz): in every window the rotation whose multiples stand out most in both sides together."""
    size, padded = int(window_s * RATE_HZ), 8 * int(window_s * RATE_HZ)
    frequency = np.fft.rfftfreq(padded, 1.0 / RATE_HZ)
    band = (frequency > ROTATION_HZ[0] * (TRACKED_ORDERS[0] - 1)) & (frequency < ROTATION_HZ[1] * (TRACKED_ORDERS[-1] + 1))
    local = int(5.0 * padded / RATE_HZ)  # 5 Hz, less than an order
    candidates = np.arange(*ROTATION_HZ, 0.001)
    times, rotations = [], []
    for first in range(0, len(samples["left"]) - size + 1, int(hop_s * RATE_HZ)):
        score = np.zeros_like(candidates)
        for x in samples.values():
            power = np.abs(np.fft.rfft(x[first : first + size] * np.hanning(size), padded))[band] ** 2
            excess = power / median_filter(power, size=local)
            for order in TRACKED_ORDERS:
                score += np.log1p(np.interp(order * candidates, frequency[band], excess))
        times.append((first + size / 2) / RATE_HZ)
        rotations.append(candidates[score.argmax()])
    return np.array(times), median_filter(np.array(rotations), size=5, mode="nearest")


def at_constant_rotation(kilometre):
    """The samples as the train would have given them at the mean rotation, and that rotation: lines of the wheel, and of
    everything that passes with the track, become as narrow as their length allows; what has a frequency of its own is widened by the
    change of speed, less than a per cent here."""
    times, rotations = rotation_along(kilometre.samples)
    count = len(kilometre.mileage_km)
    time = np.arange(count) / RATE_HZ
    turns = np.cumsum(np.interp(time, times, rotations)) / RATE_HZ
    mean = (turns[-1] - turns[0]) / (time[-1] - time[0])
    even = np.interp(turns[0] + mean * time, turns, time)
    return {side: resampled(x, even) for side, x in kilometre.samples.items()}, float(mean), (times, rotations)


def resampled(x, time, doubling=8):
    """Values between samples: straight lines in a record of eight times the rate."""
    spectrum = np.fft.rfft(x)
    fine = np.fft.irfft(np.concatenate([spectrum, np.zeros(len(x) * doubling // 2 + 1 - len(spectrum))]), len(x) * doubling) * doubling
    return np.interp(time, np.arange(len(fine)) / (RATE_HZ * doubling), fine)


def lowered_lines(x, rotation_hz, orders, reach_orders=0.06):
    """The record with the given orders brought down to the level beside them, their phases kept: what is left is
    broadband, without holes that no model would have."""
    spectrum = np.fft.rfft(x)
    order = np.fft.rfftfreq(len(x), 1.0 / RATE_HZ) / rotation_hz
    power = np.abs(spectrum) ** 2
    for n in orders:
        inside = np.abs(order - n) <= reach_orders
        beside = (np.abs(order - n) > 2 * reach_orders) & (np.abs(order - n) < 6 * reach_orders)
        level = np.mean(power[beside])
        loud = inside & (power > level)
        spectrum[loud] *= np.sqrt(level / power[loud])
    return np.fft.irfft(spectrum, len(x))


def channel_text(side, unit="m/s^2", scale="unknown"):
    return f"""[[channel]]
name = "{side}"
quantity = "acceleration"
unit = "{unit}"
scale = "{scale}"
location = "wheel"
index = 1
side = "{side}"
"""


def write_recording(folder, title, samples, speed, speed_error, scale="unknown", factor=None):
    """A recording of the sides in `samples`. With `factor` (by side) the numbers are multiplied by it."""
    folder.mkdir(parents=True)
    text = f'title = "{title}"\nsampling_rate_hz = {RATE_HZ:g}\ndata = "recording.csv"\n'
    text += f"speed_m_per_s = {speed:.6f}\nspeed_standard_error_m_per_s = {speed_error:.4f}\n"
    text += "".join(channel_text(side, scale=scale) for side in samples)
    (folder / "recording.toml").write_text(text)
    columns = [x * (factor[side] if factor else 1.0) for side, x in samples.items()]
    np.savetxt(folder / "recording.csv", np.column_stack(columns), fmt="%.5g", delimiter=",", header=",".join(samples), comments="")
    return folder


def write_as_measured(folder, kilometre):
    """The record as it came, with its speed and mileage: what is wrong with it is for the program to say."""
    folder.mkdir(parents=True)
    text = f'title = "{kilometre.name} as measured"\nsampling_rate_hz = {RATE_HZ:g}\ndata = "recording.csv"\n'
    text += "".join(channel_text(side) for side in SIDES)
    text += '[[channel]]\nname = "speed"\nquantity = "speed"\nunit = "m/s"\n[[channel]]\nname = "mileage"\nquantity = "mileage"\nunit = "km"\n'
    (folder / "recording.toml").write_text(text)
    columns = [kilometre.samples[side] + kilometre.offset[side] for side in SIDES] + [kilometre.speed_m_per_s, kilometre.mileage_km]
    np.savetxt(folder / "recording.csv", np.column_stack(columns), fmt="%.8g", delimiter=",", header="left,right,speed,mileage", comments="")
    return folder


def part(x, of):
    """The seen two thirds or the unseen third of a record."""
    cut = int(math.floor(SEEN * len(x)))
    return x[:cut] if of == "seen" else x[cut:]
