"""What the figures of the effects show: variants, the believed case where it is not simply case 1, and what to see.

Key: identifier of the effect. `variants`: label of the curve → parameters stated in its [[effect]] table, the others typical.
`believed`: options `--set` of both cases; `believed_effects`: tables of both cases. `places`: the three responses drawn.
"""

FIGURES = {}
for i, v in {
    "pad-frequency-stiffening": {"exponent 0.15": {}},
    "pad-preload-stiffening": {"strength 1": {}},
    "pad-hysteresis": {"loss factor 0.25": {}},
    "rail-shear": {"shear coefficient 0.38": {}},
    "support-compliance": {"150 kg on 60 kN/mm": {}},
    "sleeper-flexibility": {"mode at 130 Hz": {}},
    "rail-damper": {"15 kg/m at 500 Hz": {}, "15 kg/m at 120 Hz": {"frequency_hz": 120.0}},
    "failed-fasteners": {"5 % at random": {}, "every 8th": {"every": 8}},
    "sleeper-passing": {"three times": {}},
    "wheel-out-of-roundness": {"wheel 1, order 3, 50 µm": {"wheel": 1, "order": 3}},
    "rail-corrugation": {"0.3 m, 20 µm rms": {}},
    "rail-joints": {"1 mm deep every 25 m": {}},
    "irregularity-spectrum": {"+4 dB, +1 dB/octave": {}},
    "body-bending": {"9.5 Hz": {}},
    "wheelset-bending": {"80 Hz": {}},
    "bogie-mounted-mass": {"400 kg at 20 Hz": {}},
    "primary-damper-series-stiffness": {"4 kN/mm": {}},
    "secondary-damper-series-stiffness": {"4 kN/mm": {}},
    "suspension-friction": {"primary, 1.5 kN": {"stage": "primary"}, "secondary, 1.5 kN": {"stage": "secondary"}},
    "contact-nonlinearity": {"three times": {}},
    "contact-filter": {"6 mm": {}},
    "sensor-gain": {"bogie 1 reads 15 % too high": {"channel": "bogie_1"}},
    "sensor-resonance": {"axle box 1, 250 Hz": {"channel": "axlebox_1"}},
    "sensor-noise": {"body": {"channel": "body_front"}},
    "timing-skew": {"bogie 1 late by 2 ms": {"channel": "bogie_1"}},
    "parameter-error": {"pads 40 % stiffer": {"parameter": "track.pads.static_stiffness_n_per_m"}},
}.items():
    FIGURES[i] = {"title": "", "text": "x\ny", "variants": v}
FIGURES["sleeper-flexibility"]["believed_effects"] = '\n[[effect]]\nid = "support-compliance"\n'
FIGURES["sleeper-passing"]["believed"] = ("sleeper_passing.amplitude_factor=1",)
FIGURES["contact-nonlinearity"]["believed"] = ("contact.nonlinearity_factor=1", "irregularity.level_db=20")
FIGURES["body-bending"]["places"] = ("bogie_1", "body_front", "body")

for i in ("pad-frequency-stiffening", "pad-preload-stiffening", "pad-hysteresis", "rail-shear", "support-compliance", "sleeper-flexibility", "rail-damper", "sleeper-passing", "wheel-out-of-roundness", "rail-corrugation", "contact-nonlinearity", "contact-filter", "wheelset-bending", "parameter-error","sensor-resonance"):
    FIGURES[i]["from_hz"] = 10.0
