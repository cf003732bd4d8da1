"""Sturm: the blur of an astigmatic eye, path traced and predicted.

Names carry units. Frames: the wearer's (x to the wearer's right, y up), prescriptions in TABO degrees. All computing is done by the C++
functions that the command line calls, without Python's lock.
"""
from ._core import BlurField, Wavefront, parse_prescription, read_picture, read_prescription_table, refraction, schema, validate, write_picture
from ._core import __commit__, __version__
from ._documents import load, shipped
from ._ellipses import STATUS, ellipse, ellipses
from ._errors import InputError, RuntimeFailure
from ._eyes import Eye, Spectacles
from ._pictures import METRICS, Comparison, Picture, compare, predict, render, see
from ._studies import Judgement, PointSpread, judge, point_spreads

__all__ = [
    "BlurField", "Comparison", "Eye", "InputError", "Judgement", "METRICS", "Picture", "PointSpread", "RuntimeFailure", "STATUS",
    "Spectacles", "Wavefront", "compare", "ellipse", "ellipses", "judge", "load", "parse_prescription", "point_spreads", "predict",
    "read_picture", "read_prescription_table", "refraction", "render", "schema", "see", "shipped", "validate", "write_picture",
]
