"""What Wei et al. (2016) quote in words and tables, in SI units. Data only; see cases/wei2016/README.md for the source."""

SECANT_STIFFNESS_N_PER_M = 26.7e6       # section 3.2, equation (1)
CLIP_PRELOAD_N = 20e3                   # section 2.2.1
FAR_DEFLECTION_M = 1.8e-3               # section 3.2
FAR_STIFFNESS_N_PER_M = 19.1e6
LARGEST_DEFLECTION_M = 3.4e-3
LARGEST_STIFFNESS_N_PER_M = 37.9e6

# Largest PSD and its frequency, (m/s²)²/Hz at Hz, by case: sections 4.3.3 and 4.3.4.
WHEEL_PEAKS = {"case1": (57.6, 4.2), "case2": (66.7, 7.0), "case3": (75.1, 7.8)}
RAIL_PEAKS = {"case1": (76.1, 4.1), "case2": (84.7, 6.2), "case3": (85.0, 6.9)}

# Bogie at two frequencies, section 4.3.2: points A (relative to case 1) and B (relative to case 3) of Figure 8.
BOGIE_LEVELS = {
    37.0: {"case1": 0.087, "case2": 0.931 * 0.087, "case3": 0.908 * 0.087},
    73.7: {"case1": 0.370 * 0.12, "case2": 0.833 * 0.12, "case3": 0.12},
}
