"""OpenEXR files by their published layout, without a library: the attributes of a single-part file, and its packed pixels."""
import struct
import zlib

MAGIC = 20000630
LINES_PER_BLOCK = {0: 1, 2: 1, 3: 16}  # by compression: none, ZIPS, ZIP


def read_header(data):
    """{attribute: (type, bytes)} of a single-part file, and where the header ends."""
    magic, _ = struct.unpack_from("<II", data)
    if magic != MAGIC:
        raise ValueError("not an OpenEXR file")
    at, attributes = 8, {}
    while data[at]:
        end = data.index(b"\0", at)
        name = data[at:end].decode()
        type_end = data.index(b"\0", end + 1)
        size = struct.unpack_from("<i", data, type_end + 1)[0]
        first = type_end + 5
        attributes[name] = (data[end + 1:type_end].decode(), data[first:first + size])
        at = first + size
    return attributes, at + 1


def channel_names(attributes):
    data, names = attributes["channels"][1], []
    at = 0
    while data[at]:
        end = data.index(b"\0", at)
        names.append(data[at:end].decode())
        at = end + 1 + 16  # pixel type, linearity, sampling
    return names


def size(attributes):
    left, bottom, right, top = struct.unpack("<4i", attributes["dataWindow"][1])
    return right - left + 1, top - bottom + 1


def packed_pixels(data):
    """The bytes of all pixel blocks; the table of their file offsets, which moves with the header, is left out."""
    attributes, at = read_header(data)
    lines = LINES_PER_BLOCK[attributes["compression"][1][0]]
    blocks = -(-size(attributes)[1] // lines)
    return data[at + 8 * blocks:]


def float_pixels(data):
    """{channel: rows of floats} of a file with 32-bit float channels in lines of ZIP, ZIPS or no compression, whole window at the origin."""
    attributes, at = read_header(data)
    width, height = size(attributes)
    names = channel_names(attributes)
    compression = attributes["compression"][1][0]
    lines = LINES_PER_BLOCK[compression]
    at += 8 * -(-height // lines)
    rows = {name: [None] * height for name in names}
    while at < len(data):
        first, packed = struct.unpack_from("<ii", data, at)
        block = data[at + 8:at + 8 + packed]
        at += 8 + packed
        count = min(lines, height - first)
        if len(block) < 4 * width * len(names) * count:
            block = _unpredicted(zlib.decompress(block))
        values = struct.unpack(f"<{len(block) // 4}f", block)
        for y in range(count):
            for c, name in enumerate(names):
                start = (y * len(names) + c) * width
                rows[name][first + y] = values[start:start + width]
    return rows


def _unpredicted(data):
    """Undoes OpenEXR's preparation for zlib: differences of neighbouring bytes, then even bytes before odd ones."""
    sums, last = bytearray(data), data[0]
    for i in range(1, len(sums)):
        last = sums[i] = (last + sums[i] - 128) & 255
    result, half = bytearray(len(sums)), (len(sums) + 1) // 2
    result[0::2], result[1::2] = sums[:half], sums[half:]
    return bytes(result)
