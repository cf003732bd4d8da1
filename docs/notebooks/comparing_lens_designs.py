# %% [markdown]
# # Comparing lens designs
#
# Two progressive lenses for the same wearer: one with a wide far zone, one with a wide near zone. Where does each give sharp sight of a
# book at 0.33 m, and of the far distance?

# %%
import math

import numpy as np

import sturm

wearer = sturm.Eye(prescription="-1.00 DS VD 12", pupil_diameter_mm=4, accommodation={"mode": "best", "age_years": 60})
designs = {name: sturm.Spectacles(f"progressive_{name}", wearer) for name in ("wide_far", "wide_near")}
azimuth_deg = np.arange(-30, 31)
elevation_deg = np.arange(-40, 16)
gazes = np.meshgrid(azimuth_deg, elevation_deg)
print(len(azimuth_deg) * len(elevation_deg), "directions of gaze")

# %% [markdown]
# `ellipses` follows the chief ray of every gaze through both surfaces of the lens. Divided by the radius of the pupil, the larger semi-axis
# is the defocus that would blur as much [D].


# %%
def blur_D(lens, distance_m):
    return sturm.ellipses(wearer, distance_m, *gazes, lens)["semi_major_rad"] / 2e-3


for task, distance_m in (("far", math.inf), ("book", 0.33)):
    for name, lens in designs.items():
        blur = blur_D(lens, distance_m)
        share = np.mean(blur < 0.25)  # what a lens stops is NaN, and is not sharp
        print(f"{task:5} {name:9}: sharp in {100 * share:4.1f} % of the gazes, median blur {np.nanmedian(blur):.2f} D")

# %% [markdown]
# How wide is the corridor? For each row of gazes: the number of directions, one degree apart, that see less than 0.5 D of blur at the
# distance that most of them do.


# %%
def corridor_deg(lens, row_deg):
    distances_m = np.array([math.inf, 4, 2, 1, 0.7, 0.5, 0.4, 0.33, 0.28])
    rows = sturm.ellipses(wearer, distances_m, azimuth_deg[:, None], row_deg, lens)["semi_major_rad"] / 2e-3
    return int(max((rows < 0.5).sum(axis=0)))


for row_deg in (0, -10, -20, -30, -40):
    print(f"{row_deg:4} deg:", {name: f"{corridor_deg(lens, row_deg)} deg" for name, lens in designs.items()})
