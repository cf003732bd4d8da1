"""How far two pictures are apart, RGB row by row as lists of numbers."""

BRIGHTEST = 15 / 16  # of page_in_browser.emissive_view


def differences(first, second):
    """Of each pixel, the largest of its channels'."""
    return [max(abs(first[3 * i + c] - second[3 * i + c]) for c in range(3)) for i in range(len(first) // 3)]


def rmse(first, second):
    return (sum((a - b) ** 2 for a, b in zip(first, second)) / len(first)) ** 0.5


def same_passes(page, program, passes):
    """A ray that passes within rounding of an edge may fall on either side of it: 0.16 % of pixels when this was first measured, and a pass of one or two."""
    apart = differences(page, program)
    return sum(d > 1e-6 for d in apart) < 0.005 * len(apart) and max(apart) <= 2 * BRIGHTEST / passes
