"""8-bit RGB PNG files by their published layout, without a library."""
import struct
import zlib


def encode(rows):
    """A PNG of rows of (r, g, b)."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    flat = [bytes(value for pixel in row for value in pixel) for row in rows]
    # Filter 1: what is left when the pixel before is taken away.
    body = b"".join(b"\1" + row[:3] + bytes((a - b) & 255 for a, b in zip(row[3:], row)) for row in flat)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b"")


def size(data):
    return struct.unpack(">II", data[16:24])


def decode(data):
    """Rows of (r, g, b), of an 8-bit RGB file without interlace."""
    (width, _), at, packed = size(data), 8, b""
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return [[tuple(row[x:x + 3]) for x in range(0, 3 * width, 3)] for row in unfiltered(zlib.decompress(packed), 3 * width, 3)]


def unfiltered(raw, stride, pixel):
    """The rows of `stride` bytes behind the row filters; a pixel has `pixel` bytes."""
    rows, above = [], bytearray(stride)
    for start in range(0, len(raw), stride + 1):
        row = bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            row[i] = (row[i] + _guess(raw[start], row, above, i, pixel)) & 255
        rows.append(row)
        above = row
    return rows


def _guess(method, row, above, i, pixel):
    """What a row filter (PNG specification, 9.2) predicts for byte i."""
    left, up, corner = (row[i - pixel] if i >= pixel else 0), above[i], (above[i - pixel] if i >= pixel else 0)
    if method == 4:
        return min((left, up, corner), key=lambda v: abs(left + up - corner - v))
    return (0, left, up, (left + up) // 2)[method]
