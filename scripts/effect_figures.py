"""What the figures of the effects show: variants, the believed case where it is not simply case 1, and what to see.

Key: identifier of the effect. `variants`: label of the curve → parameters stated in its [[effect]] table, the others typical.
`believed`: options `--set` of both cases; `believed_effects`: tables of both cases. `places`: the three responses drawn.
`from_hz`: first frequency drawn. `lines`: the effect is made of lines, so ratios are drawn line by line.
"""

TRACK = {"from_hz": 10.0}  # everything below the wheels shows above 10 Hz

FIGURES = {
    "pad-frequency-stiffening": TRACK | {
        "title": "the pads stiffen with frequency",
        "variants": {"exponent 0.15": {}},
        "text": "At 60 Hz the pads are 1.5 times as stiff as believed: the wheels resonate on them higher (58 → 67 Hz). Less below the resonance, more above;\n"
                "the same on all channels, because everything above the wheels is as believed. The ripples are the coupling of the two wheels of a bogie by the rail.",
    },
    "pad-preload-stiffening": TRACK | {
        "title": "the pads under the wheels are stiffer",
        "variants": {"strength 1": {}},
        "text": "At rest the pads under the wheels have 38 kN/mm and those far from them 19, instead of 26.7 everywhere. The resonance of the wheels moves up:\n"
                "less below 50 Hz, more above. Beside the mean shift the ripples change, because the rail between the wheels is on the softer pads.",
    },
    "pad-hysteresis": TRACK | {
        "title": "a loss factor instead of a dashpot",
        "variants": {"loss factor 0.25": {}},
        "text": "The dashpot of case 1 dissipates more than the loss factor above some 20 Hz, ever more with frequency. Without it the resonance of the wheels\n"
                "is 5 dB higher; above 100 Hz the pad no longer holds the rail by its dashpot, and the wheels are isolated: −12 dB at 200 Hz.",
    },
    "rail-shear": TRACK | {
        "title": "the rail shears and its section rotates",
        "variants": {"shear coefficient 0.38": {}},
        "text": "At these frequencies shear only makes the track slightly softer: the wheels resonate a little lower, a quarter of a dB more below 60 Hz and\n"
                "half a dB less above. What it changes much is the sleeper-passing line and everything near the pinned–pinned frequency (1 kHz).",
    },
    "support-compliance": TRACK | {
        "title": "a mass on a spring under the pads",
        "variants": {"150 kg on 60 kN/mm": {}},
        "text": "Pad and ballast in series are softer: the wheels resonate at 45 instead of 58 Hz. Between 50 and 130 Hz there is less, 9 dB at 80 Hz. Above\n"
                "130 Hz, where the sleeper's mass stands still, the track is the believed one again. Softer pads would stay below.",
    },
    "sleeper-flexibility": TRACK | {
        "title": "the sleeper bends under the rail",
        "believed_effects": '\n[[effect]]\nid = "support-compliance"\n',
        "variants": {"mode at 130 Hz": {}},
        "text": "Both curves have sleepers (support-compliance). Bending makes the support softer below the mode, so the wheels resonate lower and there is less\n"
                "above 45 Hz; near the mode (raised by the ballast beneath it) sleeper and rail move against each other, and the coupling of the wheels changes.",
    },
    "rail-damper": TRACK | {
        "title": "tuned masses hang on the rail",
        "variants": {"15 kg/m at 500 Hz": {}, "15 kg/m at 120 Hz": {"frequency_hz": 120.0}},
        "text": "Below its frequency a damper is a heavier rail, 0.5 dB at most: a train hardly feels a damper tuned to 500 Hz. Tuned to 120 Hz it pulls with the\n"
                "rail below (less) and against it above (1.5 dB more at 130 Hz). Decay rates along the rail show it far better.",
    },
    "failed-fasteners": {
        "title": "some fasteners carry little",
        "believed": ("solver.moving=true",),
        "variants": {"5 % at random": {}, "every 8th": {"every": 8}},
        "text": "The rail sags further over a failed seat under the standing load, and the wheels ride through the dents. Every 8th: lines at multiples of\n"
                "v/4.8 m = 4.6 Hz, fewer and fewer, and a slightly softer track. At random: broadband between 3 and 20 Hz, where the waves are as long as a dent.",
    },
    "sleeper-passing": {
        "title": "the supports are felt more than the case says",
        "believed": ("sleeper_passing.amplitude_factor=1",), "from_hz": 10.0, "lines": True,
        "variants": {"three times": {}},
        "text": "A line at v/0.6 m = 37 Hz and a faint one at 74 Hz. Both curves have it; three times its amplitude is 9.5 dB where nothing else is. On this soft\n"
                "pad it is small (0.16 m/s² rms on the axle box as computed from the case), so the line stands only a little over the irregularity.",
    },
    "wheel-out-of-roundness": {
        "title": "a wheel is not round",
        "variants": {"wheel 1, order 3, 50 µm": {"wheel": 1, "order": 3}}, "from_hz": 10.0, "lines": True,
        "places": ("wheel_1", "wheel_2", "bogie_1"),
        "text": "A line at 3 v/(2πR) = 25 Hz, strong on the axle box of its own wheel. The other wheel of the bogie gets the little that rail and bogie pass on;\n"
                "the bogie feels both. A defect of the rail would be the same on both wheels.",
    },
    "rail-corrugation": TRACK | {
        "title": "the rail is corrugated",
        "variants": {"0.3 m, 20 µm rms": {}},
        "text": "Waves of 0.3 m add power around v/0.3 m = 74 Hz, in a band as wide as their wavelengths are spread (8 %), on every channel alike. At another\n"
                "speed the bump moves with v; a resonance would stay.",
    },
    "rail-joints": {
        "title": "dips at a regular distance",
        "variants": {"1 mm deep, 1 m long, every 25 m": {}},
        "text": "Lines every v/25 m = 0.9 Hz, as high as the spectrum of a single dip: 1 m long, so up to about 2v/1 m = 44 Hz. They stand out between 5 and\n"
                "22 Hz, where the believed irregularity is small; above, its short waves cover them.",
    },
    "irregularity-spectrum": {
        "title": "the track is rougher, its long waves more so",
        "variants": {"+4 dB, +1 dB/octave": {}},
        "text": "Every channel changes alike and by a straight line: 4 dB at the wavelength of 3 m (7.4 Hz at this speed) and one dB per octave. At another\n"
                "speed the line shifts with the wavelengths.",
    },
    "body-bending": {
        "title": "the car body bends",
        "variants": {"9.5 Hz": {}}, "places": ("bogie_1", "body_front", "body"),
        "text": "A peak at 9.5 Hz: 21 dB at the centre, 11 dB over the bogie, half of that on the bogie itself. Above it the centre moves less than a rigid body\n"
                "would (−11 dB): what the pivots push up bends the centre down (modal shape −0.4 over the pivots).",
    },
    "wheelset-bending": TRACK | {
        "title": "the axle bends",
        "variants": {"80 Hz, modal mass 3000 kg": {}},
        "text": "At 67 Hz, √(m/(m + M)) of the free frequency, the bending axle absorbs: force on the wheel moves nothing. Above the mode the axle no longer\n"
                "follows and the wheels are lighter (3000 and 1350 kg side by side: 930 kg), so they move more: +4 dB. Bogie and body follow their wheels.",
    },
    "bogie-mounted-mass": {
        "title": "equipment hangs on the bogie frame",
        "variants": {"400 kg at 20 Hz": {}},
        "text": "At its frequency the mass holds the bogie frame still: a dip of 2.7 dB at 20 Hz on the bogie and on the body above it, nothing on the axle box\n"
                "(0.05 dB). It stays at 20 Hz at every speed.",
    },
    "primary-damper-series-stiffness": {
        "title": "the primary damper acts through a spring",
        "variants": {"4 kN/mm": {}},
        "text": "Above 13 Hz (k_s/(2πc)) the spring gives way instead of the damper. The bogie is isolated far better, −20 dB at 200 Hz; what the damper took\n"
                "from the wheels is missing: +2.5 dB at their resonance. Around 10 Hz the bogie is damped less: +2 dB.",
    },
    "secondary-damper-series-stiffness": {
        "title": "the secondary damper acts through a spring",
        "variants": {"4 kN/mm": {}},
        "text": "Above 3 Hz (k_s/(2πc)) the spring gives way instead of the damper. The body is isolated far better, −30 dB at 200 Hz, but bounces more at 2 Hz;\n"
                "the bogie, which the secondary damper held, moves up to 10 dB more at 15 Hz. The axle box feels next to nothing.",
    },
    "suspension-friction": {
        "title": "dry friction in the suspension",
        "variants": {"primary, 1.5 kN": {"stage": "primary"}, "secondary, 1.5 kN": {"stage": "secondary"}},
        "text": "On this smooth track little moves, so friction is strong damping. Primary: the wheels are damped (−1.4 dB at 60 Hz) and the bogie is tied to them\n"
                "(+4 dB). Secondary: the bogie is held by the body (−4 dB around 20 Hz), the bounce is lower, and the body gets the rest (+6 dB at 200 Hz).",
    },
    "contact-nonlinearity": TRACK | {
        "title": "the contact softens and opens more than the Hertz law",
        "believed": ("contact.nonlinearity_factor=1", "irregularity.level_db=10"),
        "variants": {"three times": {}},
        "text": "Drawn on a track 10 dB rougher, both curves with the Hertz contact; the effect is 0.02 dB even there, and 0.002 dB on case 1 itself: a contact\n"
                "that hardly opens is nearly linear. What opens now and then is softer in the mean: more below the resonance of the wheels, less above.",
    },
    "contact-filter": TRACK | {
        "title": "the contact patch averages short waves",
        "variants": {"6 mm": {}},
        "text": "At 80 km/h 200 Hz is a wave of 11 cm, long beside a patch of 12 mm: 0.13 dB. The loss grows with the cube of the frequency, alike on all\n"
                "channels; it matters for slow trains and for noise, above 500 Hz.",
    },
    "sensor-gain": {
        "title": "a channel reads too high",
        "variants": {"bogie 1 reads 15 % too high": {"channel": "bogie_1"}},
        "text": "1.2 dB on that channel at every frequency, and nothing anywhere else: no physics does that.",
    },
    "sensor-resonance": TRACK | {
        "title": "the mount of a sensor resonates",
        "variants": {"axle box 1, mount at 250 Hz": {"channel": "axlebox_1"}},
        "text": "That channel reads more and more towards 250 Hz: 1/|1 − (f/250 Hz)²|, 9 dB at 200 Hz. The bogie above it does not know.",
    },
    "sensor-noise": {
        "title": "noise on a channel",
        "variants": {"body, 0.1 m/s², 1/f": {"channel": "body_front"}},
        "text": "1/f noise fills the dips, where the two wheels of a bogie cancel each other, and covers the quiet ends of the spectrum. It is incoherent with\n"
                "every other channel, which a spectrum alone cannot tell.",
    },
    "timing-skew": {
        "title": "a channel is late",
        "variants": {"bogie 1 late by 2 ms": {"channel": "bogie_1"}},
        "text": "No spectrum shows it: all differences are nothing. Only the phase between this channel and the others turns, by 360° · 2 ms · f: 7° at 10 Hz,\n"
                "72° at 100 Hz. That is in the cross-spectra which the diagnosis compares.",
    },
    "parameter-error": TRACK | {
        "title": "a believed value is wrong",
        "variants": {"pads 40 % stiffer": {"parameter": "track.pads.static_stiffness_n_per_m"}},
        "text": "Pads 1.4 times as stiff as believed: the resonance of the wheels moves up, less below 50 Hz and more above. Compare pad-frequency-stiffening: at\n"
                "one speed another dashpot makes the two alike, which is how a retuned parameter hides missing physics.",
    },
}
