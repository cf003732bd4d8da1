"""Files to open in the page: models of glowing rectangles whose pictures the program draws as well, and surroundings."""
import io
import struct
import zipfile

from gltf_models import REPEAT, Model
from picture_files import exr, png, radiance

# No two texels alike, all within a factor of 1.9 after decoding, so that no lamp gets passes of its own in the program.
TEXELS = [[(255, 210, 190), (200, 240, 250), (220, 190, 230)], [(190, 250, 210), (240, 200, 190), (205, 225, 255)]]
# Two triangles, larger below and to the right: nothing about them is symmetric.
SHAPE, FACES = [(-1, -1, 0), (1.5, -1, 0), (1, 1, 0), (-1, 0.5, 0)], [0, 1, 2, 0, 2, 3]
COORDINATES = [(0, 1), (1, 1), (1, 0), (0, 0)]


def gltf(path):
    """A .gltf with its buffer and its picture in files beside it: a turned, stretched and mirrored node within another one, a moved texture, and a
    camera. Returns all files."""
    model = Model()
    model.add("images", uri="my%20picture.png")
    model.add("samplers", magFilter=9728, minFilter=9728, wrapS=REPEAT, wrapT=REPEAT)
    model.add("textures", source=0, sampler=0)
    moved = {"KHR_texture_transform": {"offset": [0.1, 0.2], "scale": [1.2, 0.7], "rotation": 0.4}}
    model.extension("KHR_texture_transform")
    black = {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 1}
    mapped = model.add("materials", name="mapped", pbrMetallicRoughness=black, emissiveFactor=[1, 1, 1], emissiveTexture={"index": 0, "extensions": moved}, doubleSided=True)
    plain = model.add("materials", name="plain", pbrMetallicRoughness=black, emissiveFactor=[0.9, 0.8, 0.7], doubleSided=True)
    wall = model.add("materials", name="wall", pbrMetallicRoughness=black, emissiveFactor=[0.6, 0.7, 0.8], doubleSided=True)
    inner = model.square(mapped, corners=SHAPE, coordinates=COORDINATES, indices=FACES)
    model.json["nodes"][inner].update(translation=[0.2, 0.1, 0.3], rotation=[0, 0.2588190451, 0, 0.9659258263], scale=[-0.5, 0.4, 1])
    model.json["scenes"][0]["nodes"].remove(inner)
    model.node(children=[inner], translation=[0, 0, -2], scale=[1, 1.2, 1])
    model.square(plain, corners=[(0.4, -0.6, -1.2), (0.7, -0.6, -1.2), (0.7, -0.2, -1.4), (0.4, -0.3, -1.4)])
    model.square(wall, corners=[(-9, -9, -5), (9, -9, -5), (9, 9, -5), (-9, 9, -5)])
    model.add("cameras", type="perspective", perspective={"yfov": 0.7, "znear": 0.01})
    model.node(camera=0, translation=[0.1, 0.05, 0.2])
    model.write(path, "parts.bin")
    buffer, picture = path.parent / "parts.bin", path.parent / "my picture.png"
    buffer.write_bytes(model.binary)
    picture.write_bytes(png(TEXELS))
    return [path, buffer, picture]


def add_lamp(model):
    """A lamp without a surface, which neither the program nor the page takes from a model."""
    model.extension("KHR_lights_punctual")
    model.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 50}]}}
    model.node(translation=[0, 1, 0], extensions={"KHR_lights_punctual": {"light": 0}})


def obj(path):
    """An OBJ file with a library and a picture that it names. Returns all files."""
    library, picture = path.with_suffix(".mtl"), path.with_name("texels.png")
    path.write_text(f"mtllib {library.name}\n" + "".join(f"v {x} {y} {z - 2}\n" for x, y, z in SHAPE) + "".join(f"v {x} {y} -4\n" for x, y in ((-9, -9), (9, -9), (9, 9), (-9, 9))) +
                    "vt 0 0\nvt 1.5 0\nvt 1.5 1\nvt 0 1\nusemtl mapped\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\nusemtl wall\nf 5 6 7 8\n")
    library.write_text(f"newmtl mapped\nKd 0\nKe 0.5\nmap_Ke {picture.name}\nKs 0.5 0.5 0.5\nillum 2\nnewmtl wall\nKd 0\nKe 0.4 0.3 0.35\n")
    picture.write_bytes(png(TEXELS))
    return [path, library, picture]


USD = """#usda 1.0
(
    defaultPrim = "Room"
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Xform "Room"
{
    def Mesh "Floor"
    {
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (200, 0, 0), (200, 100, 0), (0, 100, 50)]
        rel material:binding = </Room/Paint>
    }
    def Mesh "Card"
    {
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (200, 0, 0), (200, 100, 0)]
    }
    def Material "Paint"
    {
        token outputs:surface.connect = </Room/Paint/Surface.outputs:surface>
        def Shader "Surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor = (0.75, 0.25, 0.125)
            token outputs:surface
        }
    }
}
"""


def usdz(path, packed=False):
    """In centimetres with z up: a floor of 2 m by 1 m whose fourth corner is half a metre high, with a material, and a card without one."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED if packed else zipfile.ZIP_STORED) as archive:
        archive.writestr("room.usda", USD)
    path.write_bytes(data.getvalue())
    return [path]


def surroundings(width=6, height=4):
    """rows of (r, g, b), multiples of 1/16 as 8-bit mantissas hold them; no two alike."""
    return [[((8 + x) / 16, (9 + y) / 16, (8 + (3 * x + 5 * y) % 7) / 16) for x in range(width)] for y in range(height)]


def hdr(path):
    rows = surroundings()
    # Mantissas of 256ths at the exponent 2^0.
    path.write_bytes(radiance(f"-Y {len(rows)} +X {len(rows[0])}", [(*(round(256 * c) for c in pixel), 128) for row in rows for pixel in row]))
    return [path]


def exr_of_surroundings(path):
    rows = surroundings()
    path.write_bytes(exr({name: [[pixel[k] for pixel in row] for row in rows] for k, name in enumerate("RGB")}))
    return [path]


def glb(document, data=b""):
    """Bytes of a .glb with any JSON."""
    text = document if isinstance(document, bytes) else document.encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
