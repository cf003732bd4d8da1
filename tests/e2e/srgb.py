"""The display's transfer function."""


def srgb_byte(linear):
    """255 times the transfer function of sRGB, not yet rounded to a byte."""
    linear = min(1.0, max(0.0, linear))
    return 255.0 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


def srgb_to_linear(value):
    """The light of a stored value from 0 to 1."""
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
