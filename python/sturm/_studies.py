"""Point spreads of eyes, and gates of reports."""
from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from . import _core
from ._documents import Document


@dataclasses.dataclass(frozen=True)
class PointSpread:
    """The image of a point."""

    measures: dict[str, Any]
    """Its entry in sturm.psf_result/1: model, light, target, Strehl ratios, MTF, radii [arcmin], covariance."""
    picture: np.ndarray
    """The share of the energy in each pixel, float64, row 0 at the top; the chief ray meets the middle."""
    pixel_arcmin: float
    """Side of a pixel [arcmin]."""


def point_spreads(query: Document, *, file: str = "") -> list[PointSpread]:
    """Answers a query of format sturm.psf/1, as `sturm psf` does: models, then lights, then targets vary slowest to fastest."""
    result, pictures = _core.point_spreads(query, file)
    return [PointSpread(measures, picture, pixel) for measures, (picture, pixel) in zip(result["results"], pictures)]


@dataclasses.dataclass(frozen=True)
class Judgement:
    """What gates say of a report."""

    passed: bool
    """All gates have passed, and there is one."""
    gates: list[dict[str, Any]]
    """For each gate its value, bound, unit, cases and the case that decided."""


def judge(report: Document, gates: Document, baseline: Document | None = None) -> Judgement:
    """Judges a report (sturm.report/1) by gates (sturm.gates/1), as `sturm gate` does; `baseline` is the report of an accepted run."""
    passed, results = _core.judge(report, gates, baseline)
    return Judgement(passed, results)
