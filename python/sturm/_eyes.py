"""Eyes and what they wear."""
from __future__ import annotations

from typing import Any

from . import _core
from ._documents import Document, named


class Eye(_core.Eye):
    """An eye: its correction, its pupil and how it accommodates. It does not change.

    It is given as a document of format sturm.eye/1 (a dictionary, the path of a file, or the name of a shipped eye), or by the
    members of such a document:

        Eye(prescription="-3.25 -1.75 x 160", pupil_diameter_mm=5, accommodation={"mode": "best", "age_years": 52})

    Relative paths start at the folder of `file`.
    """

    def __init__(self, document: Document | None = None, *, file: str = "", **members: Any) -> None:
        if document is None:
            document = members
        elif members:
            document = {**_core.load(named(document, "eyes")), **members}
        super().__init__(named(document, "eyes"), file)

    @property
    def wavefront(self) -> _core.Wavefront | None:
        """The wavefront over the pupil that it was measured for, or None."""
        return _core.eye_wavefront(self)

    def __repr__(self) -> str:
        rx = self.prescription
        power = f"{rx['sphere_D']:+.2f} {rx['cylinder_D']:+.2f} x {rx['axis_deg']:g}"
        return f"Eye({power}, vertex {rx['vertex_distance_mm']:g} mm, pupil {self.pupil_diameter_mm:g} mm)"


class Spectacles(_core.Spectacles):
    """A thick spectacle lens before one eye. It does not change.

    It is given as a document of format sturm.spectacles/1 (a dictionary), the path of a file in JSON or in a format of the trade,
    or the name of a shipped lens ("progressive_regular"). A lens without a prescription is made for its `wearer`.
    """

    def __init__(self, document: Document, wearer: Eye | None = None, *, file: str = "") -> None:
        super().__init__(named(document, "lenses"), wearer, file)

    def __repr__(self) -> str:
        return f"Spectacles(index {self.refractive_index:g}, {self.center_thickness_mm:g} mm thick, diameter {self.diameter_mm:g} mm)"
