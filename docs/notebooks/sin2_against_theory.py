# %% [markdown]
# # sin² interpolation against theory
#
# A cylinder of power C at the axis α is often taken for the power S + C sin²(φ − α) in the meridian φ, with the ray kept within that
# meridian. Wavefront theory also turns the ray out of its meridian. How much blur does the missing turn cost?
# [The study](../sin2_study.md) asks this of 176 904 cases; here is one of them by hand.

# %%
import numpy as np

import sturm


def semi_axes(eye, method, distances_m):
    """Semi-axes of the blur [mrad], one row for each distance, by rays through a quadrature of the pupil."""
    query = {"format": "sturm.ellipse/1", "eye": eye, "methods": [method], "rays": {"quadrature": {"radial": 8, "azimuthal": 32}},
             "targets": [{"distance_m": distance} for distance in distances_m]}
    return 1e3 * np.array([result["semi_axes_rad"] for result in sturm.ellipse(query)["results"]])


# %% [markdown]
# The eye needs +1.50 −3.00 x 30 at the cornea: its mean power is 0, and at infinity it has its circle of least confusion. A focal line lies
# at the vergence 1.5 D, that is 0.667 m.

# %%
eye = {"prescription": {"sphere_D": 1.5, "cylinder_D": -3, "axis_deg": 30, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4}
places = {"circle of least confusion": float("inf"), "focal line": 1 / 1.5}
for place, distance_m in places.items():
    theory = semi_axes(eye, "rays:power_matrix", [distance_m])[0]
    sin2 = semi_axes(eye, "rays:sin2_radial", [distance_m])[0]
    print(f"{place}: theory {theory.round(4)} mrad, sin2 {sin2.round(4)} mrad")

# %% [markdown]
# In theory the circle has the radius a·C/2 = 3 mrad, and sin² makes it √½ times as large. At the focal line the pupil becomes a line of
# half-length a·C = 6 mrad without any width; sin² makes it √(5/8) times as long and √(1/8) times its length wide. The formulas are in
# [theory](../theory.md#6-sine-squared-interpolation-against-wavefront-theory).

# %%
circle = semi_axes(eye, "rays:sin2_radial", [float("inf")])[0]
line = semi_axes(eye, "rays:sin2_radial", [1 / 1.5])[0]
print("circle:", circle / 3, "in theory", np.sqrt(1 / 2))
print("line:  ", line / 6, "in theory", np.sqrt([5 / 8, 1 / 8]))
assert np.allclose(circle / 3, np.sqrt(1 / 2), rtol=1e-9) and np.allclose(line / 6, np.sqrt([5 / 8, 1 / 8]), rtol=1e-9)
