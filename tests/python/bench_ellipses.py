"""How many blur ellipses a second NumPy gets: PYTHONPATH=build/release/python /usr/bin/python3 tests/python/bench_ellipses.py"""
import time

import numpy as np

import sturm


def rate_M_per_s(call, targets):
    """The best of seven calls: other programs only slow it down."""
    times = []
    for _ in range(7):
        started = time.perf_counter()
        call()
        times.append(time.perf_counter() - started)
    return targets / min(times) / 1e6


def main():
    relaxed = sturm.Eye(prescription="-2.00 -1.50 x 30", pupil_diameter_mm=4)
    best = sturm.Eye(prescription="-2.00 -1.50 x 30", pupil_diameter_mm=4, accommodation={"mode": "best", "amplitude_D": 4})
    lens = sturm.Spectacles("progressive_regular", best)
    distances_m = np.linspace(0.2, 6, 2_000_000)
    azimuths_deg, elevations_deg = np.meshgrid(np.linspace(-30, 30, 100), np.linspace(-30, 20, 100))
    for name, call, targets in [
        ("naked eye, relaxed", lambda: sturm.ellipses(relaxed, distances_m), distances_m.size),
        ("naked eye, best accommodation", lambda: sturm.ellipses(best, distances_m), distances_m.size),
        ("through a lens, one gaze", lambda: sturm.ellipses(best, distances_m[::20], 10, -5, lens), distances_m.size // 20),
        ("through a lens, each its gaze", lambda: sturm.ellipses(best, 1.0, azimuths_deg, elevations_deg, lens), azimuths_deg.size),
    ]:
        print(f"{name:32} {rate_M_per_s(call, targets):7.3f} M/s")


if __name__ == "__main__":
    main()
