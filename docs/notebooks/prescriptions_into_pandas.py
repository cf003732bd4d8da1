# %% [markdown]
# # 200 prescriptions into pandas
#
# A table of real prescriptions is shipped with Sturm. How blurred do their owners see the far distance, and a book, without spectacles?

# %%
import numpy as np
import pandas as pd

import sturm

people = pd.DataFrame(sturm.read_prescription_table(sturm.shipped("data/papila_prescriptions.csv"))).head(200).set_index("id")
print(people.describe().loc[["mean", "min", "max"], ["sphere_D", "cylinder_D"]].round(2))

# %% [markdown]
# Each person becomes an eye with a pupil of 4 mm and 1 D of accommodation, and each eye answers for two distances.

# %%
distances_m = {"far": np.inf, "book": 0.4}


def blur_arcmin(rx):
    prescription = {key: rx[key] for key in ("sphere_D", "cylinder_D", "axis_deg", "vertex_distance_mm")}
    eye = sturm.Eye(prescription=prescription, pupil_diameter_mm=4, accommodation={"mode": "best", "amplitude_D": 1})
    rows = sturm.ellipses(eye, list(distances_m.values()))
    return pd.Series(np.degrees(rows["semi_major_rad"]) * 60, index=distances_m)


blur = people.apply(blur_arcmin, axis=1)
print(blur.describe().loc[["50%", "mean", "max"]].round(1))

# %% [markdown]
# Who reads without spectacles? Blur of less than 2 arcmin lets a reader make out letters of 20/40.

# %%
people["refraction"] = pd.cut(people.sphere_D + people.cylinder_D / 2, [-30, -0.5, 0.5, 30], labels=["myope", "near zero", "hyperope"])
sharp = blur.lt(2).groupby(people.refraction, observed=True)
print(pd.concat([sharp.size().rename("people"), (100 * sharp.mean()).round(0).astype(int).add_suffix(", sharp %")], axis=1))
