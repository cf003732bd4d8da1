"""Pictures as other programs write them, by the published layouts and without a library: EXR, Radiance HDR, PFM, PNG, float TIFF."""
import struct
import zlib

UINT, HALF, FLOAT = 0, 1, 2
SYMBOL = {UINT: "I", HALF: "e", FLOAT: "f"}
REC709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)


def _attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def _exr_header(channels, data, display, extra):
    """channels: {name: (type, rows, side of the blocks that have one value)}"""
    listed = b"".join(name.encode("latin-1") + b"\0" + struct.pack("<iB3xii", kind, 0, step, step)
                      for name, (kind, _, step) in sorted(channels.items())) + b"\0"
    return (_attribute("channels", "chlist", listed) + _attribute("compression", "compression", b"\0") +
            _attribute("dataWindow", "box2i", struct.pack("<4i", *data)) + _attribute("displayWindow", "box2i", struct.pack("<4i", *display)) +
            _attribute("lineOrder", "lineOrder", b"\0") + _attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) +
            _attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)) + _attribute("screenWindowWidth", "float", struct.pack("<f", 1)) +
            b"".join(extra))


def _window(channels, corner):
    rows = next(iter(channels.values()))[1]
    return corner[0], corner[1], corner[0] + len(rows[0]) - 1, corner[1] + len(rows) - 1


def exr(channels, corner=(0, 0), display=None, chromaticities=None):
    """One part. channels: {name: rows} as floats, {name: (type, rows)}, or {name: (type, rows, step)}, of which every step-th value of
    every step-th row is stored; corner: where the stored pixels start."""
    channels = {name: (*value, 1)[:3] if isinstance(value, tuple) else (FLOAT, value, 1) for name, value in channels.items()}
    data = _window(channels, corner)
    extra = [_attribute("chromaticities", "chromaticities", struct.pack("<8f", *chromaticities))] if chromaticities else []
    header = struct.pack("<II", 20000630, 2) + _exr_header(channels, data, display or data, extra) + b"\0"
    lines = [b"".join(struct.pack(f"<{len(rows[y][::step])}{SYMBOL[kind]}", *rows[y][::step])
                      for _, (kind, rows, step) in sorted(channels.items()) if y % step == 0) for y in range(data[3] - data[1] + 1)]
    at, offsets, body = len(header) + 8 * len(lines), b"", b""
    for y, line in enumerate(lines):
        offsets += struct.pack("<Q", at + len(body))
        body += struct.pack("<ii", data[1] + y, len(line)) + line
    return header + offsets + body


def exr_parts(parts):
    """Several parts. parts: {name: {channel: rows}}"""
    header, tables, chunks = struct.pack("<II", 20000630, 2 | 0x1000), [], []
    first = next(iter(parts.values()))
    display = _window({name: (FLOAT, rows, 1) for name, rows in first.items()}, (0, 0))
    for number, (name, channels) in enumerate(parts.items()):
        channels = {channel: (FLOAT, rows, 1) for channel, rows in channels.items()}
        data = _window(channels, (0, 0))
        count = data[3] + 1
        extra = [_attribute("chunkCount", "int", struct.pack("<i", count)), _attribute("name", "string", name.encode()),
                 _attribute("type", "string", b"scanlineimage")]
        header += _exr_header(channels, data, display, extra) + b"\0"
        tables.append(count)
        for y in range(count):
            line = b"".join(struct.pack(f"<{len(rows[y])}f", *rows[y]) for _, (_, rows, _) in sorted(channels.items()))
            chunks.append(struct.pack("<iii", number, y, len(line)) + line)
    header += b"\0"
    at, offsets = len(header) + 8 * sum(tables), b""
    for chunk in chunks:
        offsets += struct.pack("<Q", at)
        at += len(chunk)
    return header + offsets + b"".join(chunks)


def radiance(sizes, pixels, variables=()):
    """Flat RGBE pixels in the order of the file. sizes: "-Y 2 +X 3"; variables: lines of the header."""
    head = "".join(line + "\n" for line in ("#?RADIANCE", "FORMAT=32-bit_rle_rgbe", *variables)) + "\n" + sizes + "\n"
    return head.encode() + b"".join(bytes(pixel) for pixel in pixels)


def pfm(rows, big_endian=False, scale=1.0):
    """rows from the top, of numbers or of (r, g, b)."""
    colours = isinstance(rows[0][0], tuple)
    flat = [[value for pixel in row for value in (pixel if colours else (pixel,))] for row in rows]
    head = f"{'PF' if colours else 'Pf'}\n{len(rows[0])} {len(rows)}\n{scale if big_endian else -scale}\n"
    return head.encode() + b"".join(struct.pack(f"{'>' if big_endian else '<'}{len(row)}f", *row) for row in reversed(flat))


def png(rows, depth=8):
    """rows of numbers (grey), (v, a), (r, g, b) or (r, g, b, a)."""
    count = len(rows[0][0]) if isinstance(rows[0][0], tuple) else 1
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[count]
    flat = [[value for pixel in row for value in (pixel if count > 1 else (pixel,))] for row in rows]
    raw = b"".join(b"\0" + struct.pack(f">{len(row)}{'B' if depth == 8 else 'H'}", *row) for row in flat)

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, kind, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def float_tiff(rows):
    """32-bit floats, rows of (r, g, b), in one strip."""
    width, height = len(rows[0]), len(rows)
    body = b"".join(struct.pack("<3f", *pixel) for row in rows for pixel in row)
    start = 8
    triples = start + len(body)
    entries = [(256, 3, 1, width), (257, 3, 1, height), (258, 3, 3, triples), (259, 3, 1, 1), (262, 3, 1, 2), (273, 4, 1, start), (277, 3, 1, 3),
               (278, 3, 1, height), (279, 4, 1, len(body)), (284, 3, 1, 1), (339, 3, 3, triples + 6)]
    directory = triples + 12
    return (struct.pack("<2sHI", b"II", 42, directory) + body + struct.pack("<6H", 32, 32, 32, 3, 3, 3) + struct.pack("<H", len(entries)) +
            b"".join(struct.pack("<HHII", *entry) for entry in entries) + struct.pack("<I", 0))
