#!/usr/bin/env python3
"""Converts a USD scene (.usd, .usda, .usdc, .usdz) to a binary glTF file, which Sturm reads:

    blender -b --factory-startup -P scripts/convert_usd.py -- room.usdz room.glb

Blender does the work, and has to be one with USD: those of blender.org have it, Debian 12's does not. USD's metres per unit and up axis
are applied by Blender's importer, UsdPreviewSurface becomes the glTF material, and textures go into the file.
"""
import pathlib
import sys


def fail(message):
    print("error: " + message, file=sys.stderr)
    sys.exit(2)


def paths():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 2 or not arguments[1].lower().endswith(".glb"):
        fail("usage: blender -b --factory-startup -P scripts/convert_usd.py -- SCENE.usdz SCENE.glb")
    source, target = (pathlib.Path(argument).resolve() for argument in arguments)
    if not source.is_file():
        fail(f"there is no file {source}")
    return source, target


def main():
    try:
        import bpy
    except ImportError:
        fail("this script runs inside Blender: blender -b --factory-startup -P scripts/convert_usd.py -- SCENE.usdz SCENE.glb")
    source, target = paths()
    if not getattr(bpy.app.build_options, "usd", False):
        fail(f"Blender {bpy.app.version_string} was built without USD; the builds of blender.org have it")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.usd_import(filepath=str(source))
    if not any(thing.type == "MESH" for thing in bpy.data.objects):
        fail(f"{source} has no meshes")
    bpy.ops.export_scene.gltf(filepath=str(target), export_format="GLB", export_yup=True)
    if not target.is_file():
        fail(f"Blender wrote no {target}")


main()
