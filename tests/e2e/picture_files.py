"""Pictures as other programs write them, by the published layouts and without a library: EXR, Radiance HDR, PFM, PNG, float TIFF."""
import struct
import zlib

UINT, HALF, FLOAT = 0, 1, 2
SYMBOL = {UINT: "I", HALF: "e", FLOAT: "f"}
REC709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)


def _attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def _exr_header(channels, data, display, extra, aspect=1):
    """channels: {name: (type, rows, side of the blocks that have one value)}"""
    listed = b"".join(name.encode("latin-1") + b"\0" + struct.pack("<iB3xii", kind, 0, step, step)
                      for name, (kind, _, step) in sorted(channels.items())) + b"\0"
    return (_attribute("channels", "chlist", listed) + _attribute("compression", "compression", b"\0") +
            _attribute("dataWindow", "box2i", struct.pack("<4i", *data)) + _attribute("displayWindow", "box2i", struct.pack("<4i", *display)) +
            _attribute("lineOrder", "lineOrder", b"\0") + _attribute("pixelAspectRatio", "float", struct.pack("<f", aspect)) +
            _attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)) + _attribute("screenWindowWidth", "float", struct.pack("<f", 1)) +
            b"".join(extra))


def _window(channels, corner):
    rows = next(iter(channels.values()))[1]
    return corner[0], corner[1], corner[0] + len(rows[0]) - 1, corner[1] + len(rows) - 1


def exr(channels, corner=(0, 0), display=None, chromaticities=None, envmap=None, aspect=1):
    """One part. channels: {name: rows} as floats, {name: (type, rows)}, or {name: (type, rows, step)}, of which every step-th value of
    every step-th row is stored; corner: where the stored pixels start."""
    channels = {name: (*value, 1)[:3] if isinstance(value, tuple) else (FLOAT, value, 1) for name, value in channels.items()}
    data = _window(channels, corner)
    extra = [_attribute("chromaticities", "chromaticities", struct.pack("<8f", *chromaticities))] if chromaticities else []
    extra += [_attribute("envmap", "envmap", bytes([envmap]))] if envmap is not None else []
    header = struct.pack("<II", 20000630, 2) + _exr_header(channels, data, display or data, extra, aspect) + b"\0"
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


def png(rows, depth=8, chunks=()):
    """rows of numbers (grey), (v, a), (r, g, b) or (r, g, b, a); chunks: (name, bytes) before the pixels."""
    count = len(rows[0][0]) if isinstance(rows[0][0], tuple) else 1
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[count]
    flat = [[value for pixel in row for value in (pixel if count > 1 else (pixel,))] for row in rows]
    raw = b"".join(b"\0" + struct.pack(f">{len(row)}{'B' if depth == 8 else 'H'}", *row) for row in flat)

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, kind, 0, 0, 0)) +
            b"".join(chunk(*stated) for stated in chunks) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def icc(name, curve, colorants=((0.4361, 0.2225, 0.0139), (0.3851, 0.7169, 0.0971), (0.1431, 0.0606, 0.7141)), space=b"RGB "):
    """An ICC profile (version 2) with one curve for all channels, a function of numbers from 0 to 1; the colorants are those of red, green and
    blue under D50, sRGB's if not given."""
    table = [round(65535 * curve(i / 1023)) for i in range(1024)]
    tags = {b"desc": b"desc" + bytes(4) + struct.pack(">I", len(name) + 1) + name.encode() + bytes(79)}
    for kind in ((b"kTRC",) if space == b"GRAY" else (b"rTRC", b"gTRC", b"bTRC")):
        tags[kind] = b"curv" + bytes(4) + struct.pack(">I1024H", len(table), *table)
    if space == b"RGB ":
        for kind, xyz in zip((b"rXYZ", b"gXYZ", b"bXYZ"), colorants):
            tags[kind] = b"XYZ " + bytes(4) + struct.pack(">3i", *(round(65536 * v) for v in xyz))
    at, entries, body = 128 + 4 + 12 * len(tags), b"", b""
    for kind, data in tags.items():
        data += bytes(-len(data) % 4)
        entries += kind + struct.pack(">II", at + len(body), len(data))
        body += data
    size = at + len(body)
    header = struct.pack(">II4s4s4s4s", size, 0, b"\2\x20\0\0", b"mntr", space, b"XYZ ").ljust(36, b"\0") + b"acsp"
    return header.ljust(128, b"\0") + struct.pack(">I", len(tags)) + entries + body


def exif(orientation):
    """A directory with that tag alone."""
    return b"MM\0\x2a\0\0\0\x08" + struct.pack(">HHHIHHI", 1, 0x112, 3, 1, orientation, 0, 0)


ADOBE_AS_STORED = (0xEE, b"Adobe\0\x64\0\0\0\0\0")  # no transform of colours


def jpeg(blocks, segments=(ADOBE_AS_STORED,)):
    """A baseline JPEG of blocks of 8 x 8 pixels of one colour: rows of tuples of 1, 3 or 4 bytes; segments: (marker, bytes). Steps of 8 for the
    mean of a block, whose coefficient is 8 times that, so that values come back as they were."""
    count = len(blocks[0][0])
    segment = lambda marker, body: b"\xff" + bytes([marker]) + struct.pack(">H", 2 + len(body)) + body
    lengths = lambda of: bytes(of.get(i, 0) for i in range(1, 17))
    head = b"\xff\xd8" + b"".join(segment(*one) for one in segments) + segment(0xDB, b"\0" + b"\x08" * 64)
    head += segment(0xC0, struct.pack(">BHHB", 8, 8 * len(blocks), 8 * len(blocks[0]), count) + b"".join(bytes([i + 1, 0x11, 0]) for i in range(count)))
    head += segment(0xC4, b"\0" + lengths({4: 9}) + bytes(range(9))) + segment(0xC4, b"\x10" + lengths({1: 1}) + b"\0")
    head += segment(0xDA, bytes([count]) + b"".join(bytes([i + 1, 0]) for i in range(count)) + b"\0\x3f\0")
    bits, before = "", [0] * count
    for block in (block for row in blocks for block in row):
        for i, value in enumerate(block):
            step, before[i] = value - 128 - before[i], value - 128
            size = abs(step).bit_length()
            bits += f"{size:04b}" + (f"{step if step > 0 else step + (1 << size) - 1:0{size}b}" if size else "") + "0"
    bits += "1" * (-len(bits) % 8)
    scan = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))
    return head + scan.replace(b"\xff", b"\xff\0") + b"\xff\xd9"


def tiff_bytes(rows, photometric=2, further=()):
    """8-bit rows of (r, g, b) or (r, g, b, a), in one strip; further: (tag, number)."""
    width, height, count = len(rows[0]), len(rows), len(rows[0][0])
    body = b"".join(bytes(pixel) for row in rows for pixel in row)
    bits = 8 + len(body)
    entries = sorted([(256, 3, 1, width), (257, 3, 1, height), (258, 3, count, bits), (259, 3, 1, 1), (262, 3, 1, photometric), (273, 4, 1, 8), (277, 3, 1, count),
                      (278, 3, 1, height), (279, 4, 1, len(body)), *((tag, 3, 1, number) for tag, number in further)])
    return (struct.pack("<2sHI", b"II", 42, bits + 8) + body + struct.pack("<4H", 8, 8, 8, 8) + struct.pack("<H", len(entries)) +
            b"".join(struct.pack("<HHII", *entry) for entry in entries) + struct.pack("<I", 0))


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
