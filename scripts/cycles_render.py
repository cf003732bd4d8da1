# Renders an OBJ scene of Lambertian surfaces and emitters with Cycles, everything biased switched off. Run by scripts/bench_peer.py inside
# of Blender:
#   blender -b --factory-startup --python scripts/cycles_render.py -- JOB.json
# JOB: {"scene": OBJ, "camera": {…as in sturm.render/1…}, "aperture_radius_m", "focus_distance_m", "max_bounces", "threads",
#       "renders": [{"samples", "seed", "out": EXR}, …]}.
# Prints one line "CYCLES {json}" per render: seconds of the whole call, and Cycles' version.
import json
import math
import os
import sys
import time

import bpy
from mathutils import Matrix, Vector


def read_materials(path):
    """Name → {"albedo", "emission", "texture"} of an MTL file."""
    materials, current = {}, None
    with open(path) as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "newmtl":
                current = materials.setdefault(words[1], {"albedo": (0, 0, 0), "emission": None, "texture": None})
            elif words[0] == "Kd":
                current["albedo"] = tuple(map(float, words[1:4]))
            elif words[0] == "Ke":
                current["emission"] = tuple(map(float, words[1:4]))
            elif words[0] == "map_Kd":
                current["texture"] = os.path.join(os.path.dirname(path), words[1])
    return materials


def read_objects(path):
    """Objects of an OBJ file: [name, material, vertices, faces, texture coordinates per face]; and its MTL file."""
    vertices, coordinates, objects, library = [], [], [], None
    with open(path) as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "mtllib":
                library = os.path.join(os.path.dirname(path), words[1])
            elif words[0] == "v":
                vertices.append(tuple(map(float, words[1:4])))
            elif words[0] == "vt":
                coordinates.append(tuple(map(float, words[1:3])))
            elif words[0] == "o":
                objects.append([words[1], None, [], []])
            elif words[0] == "usemtl":
                objects[-1][1] = words[1]
            elif words[0] == "f":
                corners = [[int(index) - 1 if index else None for index in corner.split("/")] for corner in words[1:]]
                objects[-1][2].append([corner[0] for corner in corners])
                objects[-1][3].append([coordinates[c[1]] if len(c) > 1 and c[1] is not None else (0.0, 0.0) for c in corners])
    return [(name, material, vertices, faces, uv) for name, material, faces, uv in objects], library


def make_material(name, facts):
    """A one-sided emitter (the side that the winding faces), or a two-sided Lambertian surface."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if facts["emission"]:
        emission, black, mix, side = (nodes.new("ShaderNode" + kind) for kind in ("Emission", "Emission", "MixShader", "NewGeometry"))
        emission.inputs["Color"].default_value = (*facts["emission"], 1.0)
        emission.inputs["Strength"].default_value = 1.0
        black.inputs["Strength"].default_value = 0.0
        links.new(side.outputs["Backfacing"], mix.inputs["Fac"])
        links.new(emission.outputs[0], mix.inputs[1])
        links.new(black.outputs[0], mix.inputs[2])
        links.new(mix.outputs[0], output.inputs["Surface"])
        return material
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*facts["albedo"], 1.0)
    if facts["texture"]:
        picture = nodes.new("ShaderNodeTexImage")
        picture.image = bpy.data.images.load(facts["texture"])
        picture.image.colorspace_settings.name = "Non-Color"
        picture.interpolation = "Closest"
        picture.extension = "EXTEND"
        links.new(picture.outputs["Color"], diffuse.inputs["Color"])
    links.new(diffuse.outputs[0], output.inputs["Surface"])
    return material


def build_scene(path):
    objects, library = read_objects(path)
    materials = {name: make_material(name, facts) for name, facts in read_materials(library).items()}
    for name, material, vertices, faces, coordinates in objects:
        used = sorted({v for face in faces for v in face})
        place = {v: i for i, v in enumerate(used)}
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata([vertices[v] for v in used], [], [[place[v] for v in face] for face in faces])
        layer = mesh.uv_layers.new()
        for polygon, uv in zip(mesh.polygons, coordinates):
            for loop, at in zip(polygon.loop_indices, uv):
                layer.data[loop].uv = at
        mesh.materials.append(materials[material])
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def build_camera(job):
    facts = job["camera"]
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.sensor_height = "VERTICAL", 24.0
    camera.lens = 12.0 / math.tan(math.radians(facts["vfov_deg"]) / 2)
    camera.clip_start, camera.clip_end = 1e-4, 1e4
    if job["aperture_radius_m"] > 0:
        camera.dof.use_dof = True
        camera.dof.focus_distance = job["focus_distance_m"]
        camera.dof.aperture_fstop = camera.lens * 1e-3 / (2 * job["aperture_radius_m"])
    place = Vector(facts["position_m"])
    back = (place - Vector(facts["look_at_m"])).normalized()
    right = Vector(facts["up"]).cross(back).normalized()
    up = back.cross(right)
    item = bpy.data.objects.new("camera", camera)
    item.matrix_world = Matrix.Translation(place) @ Matrix((right, up, back)).transposed().to_4x4()
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item


def set_up_cycles(job):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.render.resolution_x, scene.render.resolution_y = job["camera"]["resolution"]
    scene.render.resolution_percentage = 100
    scene.render.use_compositing = scene.render.use_sequencer = False
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Raw"
    world = bpy.data.worlds.new("dark")
    world.color = (0, 0, 0)
    scene.world = world
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    for kind in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, kind + "_bounces", job["max_bounces"])


def main():
    with open(sys.argv[sys.argv.index("--") + 1]) as file:
        job = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    build_scene(job["scene"])
    build_camera(job)
    set_up_cycles(job)
    scene = bpy.context.scene
    for render in job["renders"]:
        scene.cycles.samples, scene.cycles.seed = render["samples"], render["seed"]
        scene.render.filepath = render["out"]
        start = time.monotonic()
        bpy.ops.render.render(write_still=False)
        seconds = time.monotonic() - start
        bpy.data.images["Render Result"].save_render(render["out"])
        print("CYCLES " + json.dumps({"seconds": seconds, "version": bpy.app.version_string}), flush=True)


main()
