"""glTF 2.0 files by the specification, without a library: accessors of any layout, pictures, .gltf and .glb."""
import base64
import json
import struct

from picture_files import png

BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
_LETTERS = {BYTE: "b", UNSIGNED_BYTE: "B", SHORT: "h", UNSIGNED_SHORT: "H", UNSIGNED_INT: "I", FLOAT: "f"}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
REPEAT, CLAMP, MIRROR = 10497, 33071, 33648
NEAREST = 9728

# A square before a camera at the origin that looks along -z, seen counter-clockwise from there; texture coordinates as the file has
# them, v downwards.
CORNERS = [(-1, -1, -2), (1, -1, -2), (1, 1, -2), (-1, 1, -2)]
COORDINATES = [(0, 1), (1, 1), (1, 0), (0, 0)]
TRIANGLES = [0, 1, 2, 0, 2, 3]


def mixed(first, second, share):
    return [tuple((1 - share) * a + share * b for a, b in zip(p, q)) for p, q in zip(first, second)]


class Model:
    """A file in the making. `json` may be changed at will before it is written."""

    def __init__(self):
        self.binary = bytearray()
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "accessors": [], "bufferViews": []}

    def add(self, section, **content):
        """Appends to a section of the file; returns the number."""
        self.json.setdefault(section, []).append(content)
        return len(self.json[section]) - 1

    def view(self, data, **more):
        self.binary += bytes(-len(self.binary) % 4)
        self.binary += data
        return self.add("bufferViews", buffer=0, byteOffset=len(self.binary) - len(data), byteLength=len(data), **more)

    def accessor(self, elements, component=FLOAT, stride=None, sparse=None, plain=True, **more):
        """Elements as tuples (or numbers). `sparse`: {element: value}, with `plain=False` upon zeros that are in no view."""
        rows = [e if isinstance(e, (tuple, list)) else (e,) for e in elements]
        letters = "<" + str(len(rows[0])) + _LETTERS[component]

        def packed(row):
            data = struct.pack(letters, *row)
            return data + bytes((stride or len(data)) - len(data))

        content = {"componentType": component, "count": len(rows), "type": _TYPES[len(rows[0])], **more}
        if plain:
            content["bufferView"] = self.view(b"".join(map(packed, rows)), **({"byteStride": stride} if stride else {}))
        if sparse:
            content["sparse"] = {
                "count": len(sparse),
                "indices": {"bufferView": self.view(struct.pack(f"<{len(sparse)}H", *sparse)), "componentType": UNSIGNED_SHORT},
                "values": {"bufferView": self.view(b"".join(struct.pack(letters, *v) for v in sparse.values()))}}
        return self.add("accessors", **content)

    def material(self, base=(1, 1, 1, 1), texture=None, **more):
        """A Lambert surface; `texture` is a textureInfo."""
        pbr = {"baseColorFactor": list(base), "metallicFactor": 0, "roughnessFactor": 1}
        if texture is not None:
            pbr["baseColorTexture"] = texture
        return self.add("materials", pbrMetallicRoughness=pbr, **more)

    def picture(self, rows, sampler=None):
        """A texture of its own picture inside of the file; returns a textureInfo."""
        texture = {"source": self.add("images", mimeType="image/png", bufferView=self.view(png(rows)))}
        if sampler is not None:
            texture["sampler"] = self.add("samplers", **sampler)
        return {"index": self.add("textures", **texture)}

    def primitive(self, material=None, corners=CORNERS, coordinates=COORDINATES, indices=TRIANGLES, **attributes):
        """A square; `attributes` are accessors."""
        named = dict(attributes)
        named.setdefault("POSITION", None if corners is None else self.accessor(corners))
        if coordinates is not None:
            named.setdefault("TEXCOORD_0", self.accessor(coordinates))
        content = {"attributes": {key: value for key, value in named.items() if value is not None}}
        if indices is not None:
            content["indices"] = self.accessor(indices, UNSIGNED_SHORT)
        if material is not None:
            content["material"] = material
        return content

    def node(self, *primitives, mesh=None, **more):
        """A node of the scene with a mesh of these primitives; returns its number."""
        if primitives:
            more["mesh"] = self.add("meshes", name=f"part{len(self.json['meshes'])}", primitives=list(primitives), **(mesh or {}))
        number = self.add("nodes", **more)
        self.json["scenes"][0]["nodes"].append(number)
        return number

    def square(self, material=None, **more):
        return self.node(self.primitive(material, **more))

    def wall(self, base=(1, 1, 1, 1), z=-4):
        """A large square behind."""
        return self.square(self.material(base), corners=[(-9, -9, z), (9, -9, z), (9, 9, z), (-9, 9, z)])

    def extension(self, name, required=False):
        self.json.setdefault("extensionsUsed", []).append(name)
        if required:
            self.json.setdefault("extensionsRequired", []).append(name)

    def write(self, path, buffer_uri=None):
        """.glb, or .gltf with its buffer as data, or in the file `buffer_uri` names (which the caller writes)."""
        document = {key: value for key, value in self.json.items() if value != []}
        if self.binary:
            document["buffers"] = [{"byteLength": len(self.binary)}]
        if path.suffix.lower() == ".glb":
            text = json.dumps(document).encode()
            text += b" " * (-len(text) % 4)
            data = bytes(self.binary) + bytes(-len(self.binary) % 4)
            path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") +
                             text + struct.pack("<I4s", len(data), b"BIN\0") + data)
        else:
            if self.binary:
                document["buffers"][0]["uri"] = buffer_uri or (
                    "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode())
            path.write_text(json.dumps(document))
        return path
