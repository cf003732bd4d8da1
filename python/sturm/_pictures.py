"""Pictures: rendered, predicted, seen and compared."""
from __future__ import annotations

import dataclasses
from typing import Any, Callable, Iterable

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._documents import Document

Progress = Callable[[float], object]
"""A function that is told which fraction of the work is done, 0 to 1, by the thread that asked for it."""


@dataclasses.dataclass(frozen=True)
class Picture:
    """What `render` makes. The arrays have the renderer's own memory: nothing was copied."""

    radiance: np.ndarray
    """height x width x 3, linear light, float32; row 0 at the top."""
    layers: dict[str, np.ndarray]
    """All layers by name: "depth" [m], "albedo", "normal", "variance", ...; "" is the radiance."""
    counters: dict[str, Any]
    """Rays, samples, the plan of work."""
    seconds: dict[str, float]
    """Times of the parts [s]."""
    notes: list[str]
    """What is remarkable, in words."""
    document: dict[str, Any]
    """The document with every default spelt out."""


def render(document: Document, *, file: str = "", progress: Progress | None = None) -> Picture:
    """Renders a document of format sturm.render/1, a dictionary or the path of a file, as `sturm render` does.

    progress: told the fraction done some ten times a second. Ctrl-C, or an exception of `progress`, ends the rendering. Python's lock is
    released meanwhile. Relative paths of a dictionary start at the folder of `file`.
    """
    layers, counters, seconds, notes, resolved = _core.render(document, file, progress)
    return Picture(layers[""], layers, counters, seconds, notes, resolved)


def predict(document: Document, prediction: str = "ellipses", *, file: str = "", progress: Progress | None = None) -> Picture:
    """The view of a document of format sturm.render/1 as the conoid predicts it: by "ellipses", "layered", "multipass" or "depth_psf".

    Of a path-traced view the reflections are kept; its samples are not those of a sharp view, which has 16 unless the view is a prediction.
    """
    view = _core.load(document)
    if not isinstance(document, dict):
        file = str(document)
    method = view.get("method", {})
    keys = ("samples_per_pixel", "max_bounces") if method.get("type") == "predict" else ("max_bounces",)
    kept = {key: method[key] for key in keys if key in method}
    return render({**view, "method": {**kept, "type": "predict", "prediction": prediction}}, file=file, progress=progress)


def see(picture: ArrayLike, depth_m: ArrayLike | float, eye: _core.Eye, *, vfov_deg: float, layers: Iterable[tuple[ArrayLike, ArrayLike]] = (),
        psf: str = "rays", chromatic: bool = False, parts: int = _core.usual_parts, progress: Progress | None = None) -> np.ndarray:
    """What an eye sees of a picture with depth, as `sturm see` does.

    picture: height x width x 3, linear light. depth_m: height x width [m], or one distance for the whole picture; 0 is a hole, infinity
    is allowed. vfov_deg: vertical field of view [deg]. layers: (picture, depth_m) of surfaces that the picture hides. psf: "rays" or
    "waves". chromatic: kernels for each colour. parts: of the pupil; waves have one. The result has the shape of the picture. Ctrl-C ends the work.
    """
    return _core.see_picture(picture, depth_m, eye, vfov_deg, list(layers), psf, chromatic, parts, progress)[0]


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Two pictures by all metrics."""

    values: dict[str, float | None]
    """By the keys of sturm.METRICS; None where a metric has no value (the PSNR of equal pictures)."""
    maps: dict[str, np.ndarray]
    """Local values of those metrics that have some, height x width; windowed ones lack a margin."""


METRICS: dict[str, str] = _core.metric_titles
"""The keys of all metrics of two pictures, with their titles."""


def compare(test: ArrayLike, reference: ArrayLike, *, exposure: float = 1.0, pixels_per_degree: float | None = None) -> Comparison:
    """All metrics of `sturm compare` of two pictures in linear light (height x width x 3): errors, PSNR, SSIM, MS-SSIM, FLIP, HDR-FLIP.

    exposure: factor before the display's transfer function. pixels_per_degree: for FLIP; None is its default observer.
    """
    values, maps = _core.compare_pictures(test, reference, exposure, pixels_per_degree)
    return Comparison(values, maps)
