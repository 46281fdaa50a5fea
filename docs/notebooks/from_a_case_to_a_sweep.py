# %% [markdown]
# # From a case to a sweep
#
# How loud is the wheel, and what do the pads have to do with it? Case 3 of Wei et al. 2016: a metro car on a slab track whose pads
# stiffen with load and with frequency. Run from the top folder of the project:
# `PYTHONPATH=build/release/python python3 docs/notebooks/from_a_case_to_a_sweep.py`, or cell by cell in any editor that knows `# %%`.

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

import railpem

case = railpem.Case("cases/wei2016/case3.toml")
out = pathlib.Path(tempfile.mkdtemp(prefix="railpem-"))

# %% [markdown]
# A case is read like a dictionary with dotted keys; `case.keys()` lists them all.

# %%
print(case["title"])
print("body mass", case["vehicle.body_mass_kg"], "kg, speed", case.speeds_m_per_s, "m/s, pad exponent", case["track.pads.exponent"])

# %% [markdown]
# `solve` gives one-sided spectra as numpy arrays.

# %%
response = railpem.solve(case)
wheel = response["wheel_1"]
print("responses:", ", ".join(response.names))
print(f"peak of the wheel: {wheel.max():.3g} (m/s²)²/Hz at {response.frequency_hz[wheel.argmax()]:.1f} Hz")

# %% [markdown]
# Changes are checked like the file, with the same messages, and a refused one changes nothing.

# %%
try:
    case["vehicle.body_mass_kg"] = -38500
except railpem.InputError as error:
    print(error)

constant = case.changed({"track.pads.exponent": 0.0})

# %%
figure, axes = plt.subplots()
axes.loglog(response.frequency_hz, wheel, label="pads stiffen with frequency")
axes.loglog(response.frequency_hz, railpem.solve(constant)["wheel_1"], label="they do not")
axes.set(xlabel="frequency in Hz", ylabel="wheel 1 in (m/s²)²/Hz")
axes.legend()
figure.savefig(out / "wheel.png")

# %% [markdown]
# Under the standing car every pad has its own stiffness.

# %%
pads = railpem.static(case)
print(f"dynamic stiffness from {pads.dynamic_stiffness_n_per_m.min():.3g} to {pads.dynamic_stiffness_n_per_m.max():.3g} N/m")

# %% [markdown]
# A sweep solves many cases on all cores and keeps a few quantities of each: here 21 exponents × 3 payloads.

# %%
sweep = railpem.sweep(case, {"track.pads.exponent": np.linspace(0.0, 0.3, 21), "vehicle.payload_kg": [0.0, 6000.0, 12000.0]},
                      keep=[("wheel_1", "peak-frequency"), ("wheel_1", "rms"), ("trackbed", "rms")])
peak = sweep.values[:, 0].reshape(21, 3)
exponent = sweep.parameters[:, 0].reshape(21, 3)[:, 0]
for row in sweep.rows:
    print(row)

# %%
figure, axes = plt.subplots()
for i, payload in enumerate((0, 6, 12)):
    axes.plot(exponent, peak[:, i], label=f"payload {payload} t")
axes.set(xlabel="exponent of the pad", ylabel="frequency of the wheel's peak in Hz")
axes.legend()
figure.savefig(out / "peak.png")
assert peak[-1, 0] > peak[0, 0]  # stiffer pads: the wheel on the track resonates higher
print(f"figures in {out}")
