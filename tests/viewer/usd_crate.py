"""Binary USD layers ("crate" files, version 0.8): their sections as OpenUSD's crateFile.cpp lays them out, packed without any saving of room."""
import struct

PRIM, ATTRIBUTE, RELATIONSHIP = 6, 1, 8
TYPES = {"int": 3, "float": 8, "double": 9, "token": 11, "asset": 12, "matrix4d": 15, "float2": 20, "float3": 24, "paths": 34, "tokens": 41, "specifier": 42}
FORMATS = {"int": "i", "float": "f", "double": "d", "float2": "2f", "float3": "3f", "matrix4d": "16d"}


def packed(data):
    """LZ4 with literals alone, in one chunk."""
    length = len(data)
    head = bytes([15 << 4]) + b"\xff" * ((length - 15) // 255) + bytes([(length - 15) % 255]) if length >= 15 else bytes([length << 4])
    return b"\0" + head + data


def packed_integers(values):
    """Each as a difference of 32 bits: code 3."""
    codes = bytearray((2 * len(values) + 7) // 8)
    for k in range(len(values)):
        codes[k // 4] |= 3 << 2 * (k % 4)
    steps = [value - before for before, value in zip([0, *values], values)]
    data = packed(struct.pack("<i", 0) + codes + struct.pack(f"<{len(values)}i", *steps))
    return struct.pack("<Q", len(data)) + data


class Crate:
    """`specs`: of each path its kind and its fields, each (type, value), a type with [] for a list."""

    def __init__(self, specs):
        self.specs, self.tokens, self.values = specs, [""], bytearray(88)
        self.paths = ["/", *(path for path in specs if path != "/")]

    def token(self, text):
        if text not in self.tokens:
            self.tokens.append(text)
        return self.tokens.index(text)

    def stored(self, data):
        self.values += bytes(-len(self.values) % 8)
        at = len(self.values)
        self.values += data
        return at

    def value(self, kind, value):
        number, single = TYPES[kind.removesuffix("[]")] << 48, kind.removesuffix("[]")
        if kind.endswith("[]"):
            items = [self.token(item) for item in value] if single in ("token", "asset") else value
            form = FORMATS.get(single, "I")
            return 1 << 63 | number | self.stored(struct.pack("<Q", len(items)) + b"".join(struct.pack("<" + form, *(item if isinstance(item, tuple) else (item,))) for item in items))
        if kind == "tokens":
            return number | self.stored(struct.pack("<Q", len(value)) + b"".join(struct.pack("<I", self.token(item)) for item in value))
        if kind == "paths":  # an explicit list
            return number | self.stored(struct.pack("<BQ", 3, len(value)) + b"".join(struct.pack("<I", self.paths.index(path)) for path in value))
        if kind in ("token", "asset"):
            return 1 << 62 | number | self.token(value)
        if kind in ("float", "double"):  # a double that is a float stands as one
            return 1 << 62 | number | struct.unpack("<I", struct.pack("<f", value))[0]
        if kind in ("float3", "matrix4d"):
            return number | self.stored(struct.pack("<" + FORMATS[kind], *value))
        return 1 << 62 | number | value

    def tree(self):
        """Paths in the order of the tree with their last names (of properties: negative) and jumps to their next siblings."""
        order, names, jumps = [], [], []

        def visit(path, siblings):
            children = [own for own in self.paths if own != "/" and (own.rpartition("." if "." in own else "/")[0] or "/") == path]
            at = len(order)
            order.append(self.paths.index(path))
            last = path.rpartition("." if "." in path else "/")[2]
            names.append(-self.token(last) if "." in path else self.token(last))
            jumps.append(0)
            for k, child in enumerate(children):
                visit(child, len(children) - k - 1)
            jumps[at] = (len(order) - at if siblings else -1) if children else (0 if siblings else -2)

        visit("/", 0)
        return order, names, jumps

    def write(self, path):
        fields, sets, at = [], [], []
        for spec in self.paths:
            at.append(len(sets))
            for name, (kind, value) in self.specs[spec][1].items():
                sets.append(len(fields))
                fields.append((self.token(name), self.value(kind, value)))
            sets.append(-1)
        order, names, jumps = self.tree()
        text = b"".join(token.encode() + b"\0" for token in self.tokens)
        representations = packed(b"".join(struct.pack("<Q", value) for _, value in fields))
        tokens = packed(text)
        sections = {
            "TOKENS": struct.pack("<QQQ", len(self.tokens), len(text), len(tokens)) + tokens,
            "STRINGS": struct.pack("<Q", 0),
            "FIELDS": struct.pack("<Q", len(fields)) + packed_integers([name for name, _ in fields]) + struct.pack("<Q", len(representations)) + representations,
            "FIELDSETS": struct.pack("<Q", len(sets)) + packed_integers(sets),
            "PATHS": struct.pack("<QQ", len(order), len(order)) + packed_integers(order) + packed_integers(names) + packed_integers(jumps),
            "SPECS": struct.pack("<Q", len(self.paths)) + packed_integers(list(range(len(self.paths)))) + packed_integers(at) + packed_integers([self.specs[spec][0] for spec in self.paths]),
        }
        contents = b""
        for name, data in sections.items():
            contents += struct.pack("<16sQQ", name.encode(), self.stored(data), len(data))
        end = self.stored(struct.pack("<Q", len(sections)) + contents)
        self.values[:24] = struct.pack("<8s8BQ", b"PXR-USDC", 0, 8, 0, 0, 0, 0, 0, 0, end)
        path.write_bytes(self.values)
