# %% [markdown]
# # From a recording to a verdict
#
# A case was believed and a recording disagrees. What was left out? Here the recording is made by the second, time-marching solver
# with something concealed in it, so the verdict can be held against the truth. Run from the top folder of the project:
# `PYTHONPATH=build/release/python python3 docs/notebooks/from_a_recording_to_a_verdict.py`.

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

import railpem

out = pathlib.Path(tempfile.mkdtemp(prefix="railpem-"))
believed = railpem.Case("cases/wei2016/case1.toml")

# %% [markdown]
# The believed pads have a constant stiffness. Those of the recording stiffen with frequency; nine accelerometers, 20 s, 0.02 m/s²
# of noise. (`railpem.hidden_effects()` lists what can be concealed.)

# %%
recording = railpem.simulate(believed, seconds=20.0, seed=7, hide=[("pad-frequency-stiffening", {"exponent": 0.2})], noise=0.02)
folder = recording.save(out / "run")
print(recording.names, f"{len(recording)} samples at {recording.sampling_rate_hz:g} Hz")

# %% [markdown]
# Before anything is explained: can the recording be trusted?

# %%
inspection = railpem.inspect(folder, case=believed)
print(inspection.verdict)
for fault in inspection.faults:
    print("-", fault)

# %%
response = railpem.solve(believed)
figure, axes = plt.subplots()
axes.loglog(inspection.frequency_hz[1:], inspection["axlebox_1"][1:], label="recorded")
axes.loglog(response.frequency_hz, response["wheel_1"], label="believed")
axes.set(xlim=(1, 200), xlabel="frequency in Hz", ylabel="axle box 1 in (m/s²)²/Hz")
axes.legend()
figure.savefig(out / "believed.png")

# %% [markdown]
# The diagnosis retunes the believed case within its tolerances, looks where it still fails, and asks which physics beats retuning.
# (A record of a minute and the ordinary window of 4 s tell more; this one is short so that the page runs in seconds.)

# %%
diagnosis = railpem.diagnose(believed, folder, window_s=2.0, most_effects=1)
print(diagnosis.verdict)
print(diagnosis.statement)
result = diagnosis.as_dict()
for effect in result["omitted"]:
    print(effect["effect"], {name: (p["low"], p["value"], p["high"]) for name, p in effect["parameters"].items()})
print("concealed was:", [hidden["effect"] for hidden in recording.truth()["effects"]])

# %%
wheel = next(channel for channel in diagnosis.channels if channel["channel"] == "axlebox_1")
figure, axes = plt.subplots()
axes.fill_between(wheel["frequency_hz"], wheel["low"], wheel["high"], alpha=0.3, label="recorded, 90 %")
for name in ("believed", "retuned", "diagnosed"):
    axes.loglog(wheel["frequency_hz"], wheel[name], label=name)
axes.set(xlabel="frequency in Hz", ylabel="axle box 1 in (m/s²)²/Hz")
axes.legend()
figure.savefig(out / "diagnosed.png")

# %% [markdown]
# `save` writes what the command line writes: the report, and the case with the named physics, which can be solved again.

# %%
diagnosis.save(out / "diagnosis")
diagnosed = railpem.Case(out / "diagnosis/diagnosed.toml")
low, high = (np.interp(100.0, r.frequency_hz, r["wheel_1"]) for r in (railpem.solve(believed), railpem.solve(diagnosed)))
print(f"wheel at 100 Hz: believed {low:.3g}, diagnosed {high:.3g} (m/s²)²/Hz")
print(f"report: {out / 'diagnosis/report.html'}")
assert diagnosis.verdict == "explained" and [effect["effect"] for effect in result["omitted"]] == ["pad-frequency-stiffening"]
