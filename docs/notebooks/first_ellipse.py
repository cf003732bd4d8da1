# %% [markdown]
# # A first ellipse
#
# How blurred does an astigmatic eye see at four distances? The prescription is one from the everyday: -3.25 -1.75 x 160, written for a
# lens 12 mm before the eye. The wearer is 52 years old and has taken the spectacles off.

# %%
import math

import numpy as np

import sturm

eye = sturm.Eye(prescription="-3.25 -1.75 x 160 VD 12", pupil_diameter_mm=5, accommodation={"mode": "best", "age_years": 52})
print(eye)
print({name: round(value, 3) for name, value in eye.power_vector.items()})

# %% [markdown]
# The blur of a point is an ellipse. Its semi-axes are angles at the eye; 1 arcmin is the stroke of a letter that 20/20 vision reads. The
# orientation is that of the longer axis as the wearer sees it, counter-clockwise from the right.

# %%
distances_m = [0.2, 0.4, 1, math.inf]
for distance_m, blur in zip(distances_m, sturm.ellipses(eye, distances_m)):
    major, minor = (math.degrees(blur[name]) * 60 for name in ("semi_major_rad", "semi_minor_rad"))
    along = "a circle" if math.isnan(blur["orientation_deg"]) else f"along {blur['orientation_deg']:.1f} deg"
    print(f"{distance_m:5} m: {major:4.1f} x {minor:4.1f} arcmin, {along}, accommodation {blur['accommodation_D']:.2f} D")

# %% [markdown]
# Where is the eye sharpest? Three thousand distances are one call. Between the two focal lines, where the semi-minor axis vanishes, the
# ellipse becomes a circle: the eye sees least blur there, and it is not blurred along any direction.

# %%
relaxed = sturm.Eye(prescription="-3.25 -1.75 x 160 VD 12", pupil_diameter_mm=5)
vergence_D = np.linspace(2.5, 5.5, 3001)
blur = sturm.ellipses(relaxed, 1 / vergence_D)
least = blur["semi_major_rad"].argmin()
print(f"least blur at {1 / vergence_D[least]:.3f} m: {math.degrees(blur['semi_major_rad'][least]) * 60:.1f} arcmin")
nearer = vergence_D > vergence_D[least]
for side in (nearer, ~nearer):
    line = blur["semi_minor_rad"][side].argmin()
    print(f"a focal line at {1 / vergence_D[side][line]:.3f} m")
