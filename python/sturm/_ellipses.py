"""Blur ellipses as arrays."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._documents import Document

STATUS = _core.lens_status_words
"""What became of a ray through a lens, in words: the field `status` of `ellipses` is the number of one of them, 0 the first."""


def ellipses(eye: _core.Eye, distance_m: ArrayLike, azimuth_deg: ArrayLike = 0.0, elevation_deg: ArrayLike = 0.0,
             spectacles: _core.Spectacles | None = None) -> np.ndarray:
    """Blur ellipses by conoid tracing, for all targets at once.

    distance_m: from the pupil along the line of sight, with spectacles from the front surface along the outgoing ray [m]; infinity is
    allowed. azimuth_deg, elevation_deg: gaze to the wearer's right and up [deg]. The three broadcast.

    Returns a structured array of their common shape with the fields accommodation_D, semi_major_rad, semi_minor_rad, semi_major_m,
    semi_minor_m (at the target; NaN at infinity), orientation_deg (of the major axis, wearer's frame; NaN for a circle), angular_xx,
    angular_xy, angular_yx, angular_yy (the map of the pupil [rad/m]) and status, a number in sturm.STATUS. What spectacles stop is NaN.
    The numbers are those of `sturm ellipse`, to the last bit. Python's lock is released meanwhile.
    """
    given = [np.asarray(a, dtype=np.float64) for a in (distance_m, azimuth_deg, elevation_deg)]
    shape = np.broadcast_shapes(*(a.shape for a in given))
    flat = [a.reshape(1) if a.size == 1 else np.broadcast_to(a, shape).reshape(-1) for a in given]
    return _core.ellipse_rows(eye, *flat, spectacles).reshape(shape)


def ellipse(query: Document, *, file: str = "") -> dict[str, Any]:
    """Answers a query of format sturm.ellipse/1 by every method that it names, rays included: a sturm.ellipse_result/1."""
    return _core.ellipse(query, file)
