# %% [markdown]
# # Your own photograph
#
# A sharp picture and a map of its depth are enough to see it with another eye. Here the picture is the project's desk, rendered through a
# pinhole; a photograph is read by `sturm.read_picture("photo.jpg")`, and its depth map is an array of metres.

# %%
import numpy as np

import sturm

view = sturm.load(sturm.shipped("views/desk.json"))
view["scene"] = str(sturm.shipped("scenes/desk.json"))
view["camera"]["resolution"] = [240, 160]
view["eye"]["pupil_diameter_mm"] = 0
view["method"] = {"type": "path_trace", "ray_model": "pinhole", "samples_per_pixel": 64, "max_bounces": 4}
sharp = sturm.render(view)
depth_m = sharp.layers["depth"]
print(sharp.radiance.shape, f"depth {depth_m.min():.2f} to {np.max(depth_m[np.isfinite(depth_m)]):.2f} m")

# %% [markdown]
# A measured eye with all of its aberrations looks at the mug, 0.75 m away, through a pupil of 5.7 mm. The card lies before it, at 0.28 m.

# %%
eye = sturm.Eye("hofer_5", pupil_diameter_mm=5.7, accommodation={"mode": "fixed", "focus_distance_m": 0.75})
seen = sturm.see(sharp.radiance, depth_m, eye, vfov_deg=view["camera"]["vfov_deg"])
sturm.write_picture("own_photograph_sharp.png", sharp.radiance)
sturm.write_picture("own_photograph_seen.png", seen)

# %% [markdown]
# ![The desk, sharp](own_photograph_sharp.png) ![The desk with the card in front out of focus](own_photograph_seen.png)
#
# By how much do the two differ? These are the metrics of `sturm compare`.

# %%
values = sturm.compare(seen, sharp.radiance).values
for key in ("psnr_display_dB", "ssim_display", "flip"):
    print(f"{sturm.METRICS[key]}: {values[key]:.2f}")
