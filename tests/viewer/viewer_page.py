"""Pages of `sturm view` taken apart again: the view, and the scene by its format (docs/formats/viewer_scene.md)."""
import array
import base64
import gzip
import json
import re
import struct
import sys

SKIPPED = 77
TEMPLATE = """<!doctype html>
<script id="sturm-view" type="application/json">null</script>
<script id="sturm-scene" type="text/plain"></script>
"""
TYPES = {"f32": "f", "u32": "I", "u16": "H", "u8": "B"}


def skip(reason):
    """Ends a test that needs what was not built."""
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def content_of(page, element):
    found = re.findall(rf'<script id="{element}" type="[a-z/]+">(.*?)</script>', page, re.DOTALL)
    if len(found) != 1:
        raise AssertionError(f"{len(found)} elements {element}")
    return found[0]


def view_of(page):
    return json.loads(content_of(page, "sturm-view"))


class Scene:
    """header, and numbers(place): the array that the header names, as a list."""

    def __init__(self, page):
        packed = base64.b64decode(content_of(page, "sturm-scene"), validate=True)
        file = gzip.decompress(packed)
        if file[:8] != b"STURMVS1":
            raise AssertionError("no viewer's scene")
        length = struct.unpack("<I", file[8:12])[0]
        if length % 4:
            raise AssertionError("the header does not end on a multiple of 4")
        self.header = json.loads(file[12:12 + length])
        self.data = file[12 + length:]

    def numbers(self, place):
        numbers = array.array(TYPES[place["type"]])
        if place["at"] % 4:
            raise AssertionError("an array that is not aligned")
        numbers.frombytes(self.data[place["at"]:place["at"] + place["components"] * place["count"] * numbers.itemsize])
        if sys.byteorder != "little":
            numbers.byteswap()
        return numbers.tolist()

    def rows(self, place):
        flat, width = self.numbers(place), place["components"]
        return [flat[k:k + width] for k in range(0, len(flat), width)]

    def texels(self, texture):
        """Of a picture, through its table if it has one."""
        flat = self.numbers(texture["texels"])
        if texture["table"] is None:
            return flat
        table = self.numbers(texture["table"])
        return [table[k] for k in flat]
