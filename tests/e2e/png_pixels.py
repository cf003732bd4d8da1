"""8-bit RGB PNG files as rows of pixels, and what tests ask of them."""
import sys

from sturm_process import SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
from png_rows import decode, encode, size, unfiltered  # noqa: E402, F401: for whoever imports this module


def mean_colour(rows, first, last):
    """Mean (r, g, b) of the columns first … last - 1."""
    pixels = [pixel for row in rows for pixel in row[first:last]]
    return [sum(pixel[k] for pixel in pixels) / len(pixels) for k in range(3)]
