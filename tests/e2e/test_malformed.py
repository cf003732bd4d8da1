"""Wrong input: exit status 2, stderr names file, place and value, nothing on stdout, nothing written."""
import json
import unittest

import documents
from documents import changed, without
from sturm_process import SOURCE, WRONG_INPUT, FolderTest, snapshot, sturm

OBJ = "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nf 1 2 3\n"
EXR = SOURCE / "tests/reference/images/reference.exr"


class Malformed(FolderTest):
    def reject(self, arguments, *named, stdin=None):
        """The command must fail with status 2, name all of `named`, and leave the folder as it was."""
        before = snapshot(self.folder)
        process = sturm(*arguments, stdin=stdin, cwd=self.folder)
        message = f"{arguments}: {process.stderr}"
        self.assertEqual(process.returncode, WRONG_INPUT, message)
        self.assertEqual(process.stdout, "", message)
        self.assertRegex(process.stderr, "(?m)^error: ", message)
        for text in named:
            self.assertIn(str(text), process.stderr, message)
        self.assertNotIn("json.exception", process.stderr, message)
        self.assertEqual(snapshot(self.folder), before, message)

    def reject_query(self, document, *named):
        self.write("query.json", document)
        self.reject(["ellipse", "query.json", "-o", "answer.json"], "query.json", *named)

    def reject_view(self, document, *named, file="view.json"):
        self.write("view.json", document)
        self.reject(["render", "view.json", "-o", "picture.exr", "--quiet"], file, *named)

    def reject_experiment(self, document, *named, file="experiment.json"):
        self.write("gates.json", documents.gates())
        self.write("experiment.json", document)
        self.reject(["run", "experiment.json", "--out", "report", "--quiet"], file, *named)


class Text(Malformed):
    """What is not JSON, or not JSON that can be trusted."""

    def test_places_of_syntax_errors(self):
        valid = json.dumps(documents.query())
        for name, text, *named in [
            ("empty", "", ":1:1"),
            ("blank", "\n\n", ":3:1"),
            ("truncated", valid[: len(valid) // 2], ":1:"),
            ("NaN literal", valid.replace("-2.0", "NaN"), ":1:"),
            ("Infinity literal", valid.replace("-2.0", "-Infinity"), ":1:"),
            ("trailing comma", '{\n "format": "sturm.ellipse/1",\n}', ":3:1"),
            ("comment", "// a query\n" + valid, ":1:1"),
            ("two documents", valid + valid, ":1:"),
            ("not UTF-8", valid.replace("relaxed", "rel\xffaxed").encode("latin-1"), ":1:"),
            ("binary", b"\x00\x01\x02\xff", ":1:1"),
        ]:
            with self.subTest(name):
                self.reject_query(text, *named)

    def test_overflowing_number(self):
        self.reject_query(json.dumps(documents.query()).replace("-2.0", "1e999"), "1e999")

    def test_duplicate_key(self):
        text = json.dumps(documents.query()).replace('"sphere_D"', '"sphere_D": -1.0, "sphere_D"')
        self.reject_query(text, "/eye/prescription/sphere_D", "second")

    def test_deep_nesting(self):
        self.reject_query("[" * 100000, "nested")

    def test_standard_input(self):
        self.reject(["ellipse", "-"], "/eye/pupil_diameter_mm", "-4", stdin=json.dumps(changed(documents.query(), "/eye/pupil_diameter_mm", -4)))
        self.reject(["ellipse", "-"], "stdin", ":1:1", stdin="")

    def test_missing_file_and_folder(self):
        for command in (["ellipse", "nowhere.json"], ["render", "nowhere.json", "-o", "a.exr"], ["run", "nowhere.json"],
                        ["validate", "nowhere.json"], ["gate", "nowhere.json"]):
            with self.subTest(command):
                self.reject(command, "nowhere.json", "No such file")
        (self.folder / "place").mkdir()
        for command in (["ellipse", "place"], ["render", "place", "-o", "a.exr"], ["run", "place"], ["validate", "place"], ["gate", "place"],
                        ["compare", "place", "place"]):
            with self.subTest(command):
                self.reject(command, "place")


class Query(Malformed):
    def test_values(self):
        for pointer, value, *named in [
            ("/eye/pupil_diameter_mm", -4, "-4", "0"),
            ("/eye/pupil_diameter_mm", 101, "101", "100"),
            ("/eye/pupil_diameter_mm", "4", '"4"', "number"),
            ("/eye/pupil_diameter_mm", None, "null"),
            ("/eye/prescription", [], "[]"),
            ("/eye/prescription/axis_deg", 190, "190", "180"),
            ("/eye/prescription/axis_deg", -1, "-1"),
            ("/eye/prescription/sphere_D", 1000, "1000", "40"),
            ("/eye/prescription/sphere_D", True, "true"),
            ("/eye/rotation_center_mm", -1, "-1"),
            ("/eye/accommodation", {"mode": "fixed"}, "focus_distance_m"),
            ("/eye/accommodation", {"mode": "fixed", "power_D": 1, "focus_distance_m": 1}, "focus_distance_m"),
            ("/eye/accommodation/mode", "tired", "tired", "relaxed"),
            ("/targets", [], "[]"),
            ("/targets/0/distance_m", 0, "0"),
            ("/targets/0/distance_m", -1, "-1"),
            ("/targets/0/distance_m", "infinite", "infinite", "inf"),
            ("/targets/0/gaze_deg", [0], "[0]"),
            ("/targets/0/gaze_deg/1", 90, "90", "89"),
            ("/methods", [], "[]"),
            ("/methods/0", "conoids", "conoids", 'did you mean "conoid"'),
            ("/methods/0", "rays:power_martix", "rays:power_martix", "rays:power_matrix"),
            ("/seed", -1, "-1"),
            ("/seed", 1.5, "1.5", "integer"),
            ("/rays", {"count": 0}, "/rays/count", "0"),
            ("/rays", {"count": 1 << 40}, "/rays/count", str(1 << 40)),
            ("/rays", {"replicates": 0}, "/rays/replicates"),
            ("/rays", {"sampling": "polar"}, "/rays/sampling", "uniform_polar", "uniform_disk"),
            ("/rays", {"quadrature": {"radial": 4}}, "/rays/quadrature", "azimuthal"),
            ("/rays", {"quadrature": {"radial": 4, "azimuthal": 8}, "count": 5}, "/rays/count", "5"),
            ("/rays", {"pupil_points_mm": [[3.0, 0.0]]}, "/rays/pupil_points_mm/0", "3"),
            ("/spectacles", {"vertex_distance_mm": 12}, "front", "single_vision"),
            ("/spectacles", {"single_vision": {"refractive_index": 1.5}}, "/spectacles/single_vision", "center_thickness_mm"),
            ("/format", "sturm.ellipse/2", "sturm.ellipse/2", "sturm.ellipse/1"),
        ]:
            with self.subTest(pointer=pointer, value=value):
                self.reject_query(changed(documents.query(), pointer, value), pointer, *named)

    def test_a_document_that_is_no_object(self):
        for document in ([], 5, "eye", None):
            with self.subTest(document=document):
                self.reject_query(json.dumps(document), json.dumps(document))

    def test_missing_members(self):
        for pointer in ("/eye", "/targets", "/methods", "/format", "/eye/pupil_diameter_mm", "/eye/prescription/sphere_D", "/targets/0/distance_m"):
            with self.subTest(pointer=pointer):
                parent, key = pointer.rsplit("/", 1)
                self.reject_query(without(documents.query(), pointer), parent, f'no "{key}"')

    def test_unknown_keys_with_a_suggestion(self):
        for pointer, suggestion in [("/eye/prescription/sphere_d", "sphere_D"), ("/eye/pupil_diameter", "pupil_diameter_mm"), ("/target", "targets")]:
            with self.subTest(pointer=pointer):
                self.reject_query(changed(documents.query(), pointer, -2.0), pointer, f'"{suggestion}"', "unknown")

    def test_cylinder_without_axis(self):
        self.reject_query(without(documents.query(), "/eye/prescription/axis_deg"), "/eye/prescription", "axis_deg")

    def test_vertex_distance_at_the_focal_length(self):
        query = changed(documents.query(), "/eye/prescription", {"sphere_D": 25.0, "vertex_distance_mm": 40})
        self.reject_query(query, "/eye/prescription", "40", "focal length")

    def test_named_eye_files(self):
        self.reject_query(changed(documents.query(), "/eye", "nobody.json"), "/eye", "nobody.json")
        self.write("eye.json", changed({"format": "sturm.eye/1", **documents.query()["eye"]}, "/pupil_diameter_mm", -1))
        self.write("query.json", changed(documents.query(), "/eye", "eye.json"))
        self.reject(["ellipse", "query.json"], "eye.json", "/pupil_diameter_mm", "-1")

    def test_set(self):
        self.write("query.json", documents.query())
        for assignment, *named in [
            ("/targets/7/distance_m=1", "/targets", "7"),
            ("/targets/first/distance_m=1", "first"),
            ("/eye/prescription/sphere_D/x=1", "/eye/prescription/sphere_D"),
            ("/eye/spheer_D=1", "/eye/spheer_D", "unknown"),
            ("/eye/pupil_diameter_mm=wide", "/eye/pupil_diameter_mm", '"wide"'),
            ("eye=1", "eye=1", "/pointer=value"),
            ("/eye", "/eye", "/pointer=value"),
            ("/a~2=1", "~2"),
        ]:
            with self.subTest(assignment):
                self.reject(["ellipse", "query.json", "--set", assignment], *named)


class View(Malformed):
    def test_values(self):
        for pointer, value, *named in [
            ("/camera/resolution/0", 100000, "100000", "16384"),
            ("/camera/resolution/1", 0, "0"),
            ("/camera/resolution", [48.5, 48], "48.5"),
            ("/camera/look_at_m", [0.278, 0.273, -0.8], "[0.278,0.273,-0.8]"),
            ("/camera/up", [0, 0, 3], "[0,0,3]", "parallel"),
            ("/camera/up", [0, 0, 0], "[0,0,0]"),
            ("/camera/vfov_deg", 180, "180"),
            ("/camera/projection", "fisheye", "fisheye", "perspective"),
            ("/camera/gaze", "fixed", "fixed", "camera"),
            ("/method/samples_per_pixel", 0, "0"),
            ("/method/samples_per_pixel", 1 << 30, str(1 << 30)),
            ("/method/ray_model", "sin2", "sin2", "sin2_radial"),
            ("/method/type", "raster", "raster", "path_trace"),
            ("/method/max_bounces", -1, "-1"),
            ("/method/oversampling", 2, "2"),
            ("/eye/accommodation", {"mode": "best", "age_years": 30}, "best"),
            ("/spectacles", "glasses.json", "glasses.json"),
            ("/scene", "nowhere.obj", "nowhere.obj"),
            ("/scene", "nowhere.json", "nowhere.json"),
            ("/scene", {"environment": "sky.exr"}, "/scene/environment", "sky.exr"),
        ]:
            with self.subTest(pointer=pointer, value=value):
                self.reject_view(changed(documents.view(), pointer, value), pointer, *named)

    def test_predict_takes_no_ray_model_and_path_trace_needs_one(self):
        self.reject_view(changed(documents.view(), "/method/type", "predict"), "/method/ray_model", "power_matrix")
        self.reject_view(without(documents.view(), "/method/ray_model"), "/method", "ray_model")

    def test_metalstigmatism_without_focus_distance(self):
        self.reject_view(changed(documents.view(), "/method/ray_model", "metalstigmatism"), "/eye/accommodation", "focus_distance_m")

    def test_output_names(self):
        self.write("view.json", documents.view())
        self.reject(["render", "view.json", "-o", "picture.jpg"], "--output", "picture.jpg", ".exr", ".png")

    def test_inline_scenes(self):
        for pointer, value, *named in [
            ("/scene/meshes/0/material", "gray", "gray", '"grey"'),
            ("/scene/meshes/0/faces", [], "[]"),
            ("/scene/meshes/0/faces", [[0, 1, 4]], "/scene/meshes/0/faces/0/2", "4"),
            ("/scene/meshes/0/faces", [[0, 1, 1]], "/scene/meshes/0/faces/0"),
            ("/scene/meshes/0/positions_m", [], "[]"),
            ("/scene/materials/grey/albedo", [0.5, 0.5, 1.5], "/scene/materials/grey/albedo/2", "1.5"),
            ("/scene/lights/0/type", "sun", "sun", "point"),
            ("/scene/models", [{"file": "nowhere.obj"}], "/scene/models/0/file", "nowhere.obj"),
            ("/scene/spheres", [{"center_m": [0, 0, -3], "radius_m": 0, "material": "grey"}], "/scene/spheres/0/radius_m", "0"),
        ]:
            with self.subTest(pointer=pointer, value=value):
                view = changed(documents.view(), "/scene", documents.two_triangles())
                self.reject_view(changed(view, pointer, value), pointer, *named)

    def test_model_files(self):
        self.write("empty.mtl", "newmtl silver\n")
        for name, content, *named in [
            ("noise.obj", b"\x00\xff\x13\x37" * 50),
            ("empty.obj", ""),
            ("no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
            ("nan.obj", OBJ.replace("v 0 1 -2", "v 0 nan -2"), "finite"),
            ("infinite.obj", OBJ.replace("v 0 1 -2", "v 0 1e999 -2"), "finite"),
            ("bad_index.obj", OBJ.replace("f 1 2 3", "f 1 2 9")),
            ("no_library.obj", "mtllib nowhere.mtl\n" + OBJ, "nowhere.mtl"),
            ("no_material.obj", "mtllib empty.mtl\n" + OBJ.replace("f 1", "usemtl gold\nf 1"), "gold"),
            ("broken.gltf", "{"),
            ("empty.glb", b""),
        ]:
            with self.subTest(name):
                self.write(name, content)
                self.reject_view(changed(documents.view(), "/scene", name), *named, file=name)

    def test_textures(self):
        self.write("paint.mtl", "newmtl paint\nKd 0.5 0.5 0.5\nmap_Kd nowhere.png\n")
        obj = "mtllib paint.mtl\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl paint\n" + OBJ.replace("f 1 2 3", "f 1/1 2/2 3/3")
        self.write("painted.obj", obj)
        self.reject_view(changed(documents.view(), "/scene", "painted.obj"), "nowhere.png", file="painted.obj")
        self.write("paint.mtl", "newmtl paint\nKd 0.5 0.5 0.5\nmap_Kd broken.png\n")
        self.write("broken.png", b"\x89PNG\r\n\x1a\nand no more")
        self.reject_view(changed(documents.view(), "/scene", "painted.obj"), file="broken.png")

    def test_named_scene_files(self):
        scene = changed(documents.two_triangles(), "/meshes/0/faces/0/3", 17)
        self.write("scene.json", scene)
        self.reject_view(changed(documents.view(), "/scene", "scene.json"), "/meshes/0/faces/0/3", "17", file="scene.json")


class Experiment(Malformed):
    def test_values(self):
        twin = documents.experiment()["ellipses"]["prescriptions"][0]
        for pointer, value, *named in [
            ("/psfs/0/prescription", "obliqe", "obliqe", '"oblique"'),
            ("/images/0/prescription", "nobody", "nobody", "oblique"),
            ("/ellipses/prescriptions/1", twin, "/ellipses/prescriptions/1/id", "oblique"),
            ("/psfs/0/id", "../../escape", "../../escape"),
            ("/psfs/0/resolution", 4, "4"),
            ("/psfs/0/distance_m", "inf", "inf"),
            ("/images/0/scene", "nowhere.json", "nowhere.json"),
            ("/images/0/replicates", 1, "1"),
            ("/ellipses/ray_models", ["power_matrix", "power_matrix"], "power_matrix"),
            ("/ellipses/rays/replicates", 1, "1"),
            ("/gates", "nowhere.json", "nowhere.json"),
            ("/reference", "nowhere.json", "nowhere.json"),
            ("/title", "", '""'),
            ("/elipses", {}, '"ellipses"', "unknown"),
        ]:
            with self.subTest(pointer=pointer, value=value):
                self.reject_experiment(changed(documents.experiment(), pointer, value), pointer, *named)

    def test_gates_file(self):
        for document, *named in [
            (changed(documents.gates(), "/gates/0/bound", "small"), "/gates/0/bound", '"small"'),
            (changed(documents.gates(), "/gates/1/id", "matrix_equals_conoid"), "/gates/1/id", "matrix_equals_conoid"),
            (changed(documents.gates(), "/gates/0/comparison", "less"), "/gates/0/comparison", "less", "at_most"),
            (changed(documents.gates(), "/gates", []), "/gates", "[]"),
        ]:
            with self.subTest(named):
                self.write("spoilt.json", document)
                self.reject_experiment(changed(documents.experiment(), "/gates", "spoilt.json"), *named, file="spoilt.json")

    def test_models_are_looked_at_before_anything_is_written(self):
        self.write("nan.obj", OBJ.replace("v 0 1 -2", "v 0 nan -2"))
        self.reject_experiment(changed(documents.experiment(), "/images/0/scene", "nan.obj"), "finite", file="nan.obj")

    def test_reference_is_looked_at_before_anything_is_written(self):
        self.write("numbers.json", {"cases": [{"inputs": {"S": -1}}]})
        self.reject_experiment(changed(documents.experiment(), "/reference", "numbers.json"), "/cases/0", file="numbers.json")

    def test_a_wrong_experiment_leaves_the_old_report_alone(self):
        self.write("report/report.json", {"old": True})
        self.reject_experiment(changed(documents.experiment(), "/images/0/replicates", 1), "/images/0/replicates")


class OtherCommands(Malformed):
    def test_validate(self):
        for name, document, *named in [
            ("format", {"format": "sturm.elipse/1"}, "/format", "sturm.elipse/1", "sturm.ellipse/1"),
            ("no format", {}, "format"),
            ("not an object", [1, 2], "[1,2]"),
            ("format of another type", {"format": 3}, "/format", "3"),
            ("eye", {"format": "sturm.eye/1", "pupil_diameter_mm": 4}, "prescription"),
            ("eye's value", {"format": "sturm.eye/1", "prescription": {"sphere_D": "x"}, "pupil_diameter_mm": 4}, "/prescription/sphere_D", '"x"'),
            ("scene", {"format": "sturm.scene/1", "meshes": [{}]}, "/meshes/0", 'no "'),
            ("scene's key", {"format": "sturm.scene/1", "mesh": []}, "/mesh", "meshes"),
            ("report", {"format": "sturm.report/1"}, 'no "'),
            ("result", {"format": "sturm.ellipse_result/1", "results": [{}]}, "/results/0", 'no "'),
            ("manifest", {"format": "sturm.manifest/1"}, 'no "'),
            ("render", changed(documents.view(), "/camera/up", [0, 0, 1]), "/camera/up", "[0,0,1]"),
        ]:
            with self.subTest(name):
                self.write("document.json", document)
                self.reject(["validate", "document.json"], "document.json", *named)

    def test_schema(self):
        self.reject(["schema", "elipse"], "elipse", "ellipse")

    def test_compare(self):
        good = EXR.read_bytes()
        self.write("cut.exr", good[: len(good) // 2])
        self.write("header.exr", good[:40])
        self.write("empty.exr", b"")
        self.write("text.exr", "a picture\n")
        self.write("huge.exr", self.with_huge_window(good))
        for name in ("cut.exr", "header.exr", "empty.exr", "text.exr", "huge.exr", "nowhere.exr"):
            with self.subTest(name):
                self.reject(["compare", name, EXR], name)
                self.reject(["compare", EXR, name, "--json", "out.json"], name)

    @staticmethod
    def with_huge_window(exr):
        """The file with a data window of 2^31 - 1 pixels a side: no reader may try to allocate that."""
        at = exr.index(b"dataWindow\0box2i\0") + len(b"dataWindow\0box2i\0") + 4
        return exr[:at + 8] + b"\xff\xff\xff\x7f" * 2 + exr[at + 16:]

    def test_compare_needs_equal_sizes(self):
        self.write("view.json", changed(documents.view(), "/camera/resolution", [12, 16]))
        self.succeed("render", self.folder / "view.json", "-o", self.folder / "small.exr", "--quiet")
        self.reject(["compare", "small.exr", EXR], "12", "16", "160", "128")

    def test_gate(self):
        for document, *named in [
            ({"format": "sturm.report/1", "title": "t"}, 'no "'),
            ({"format": "sturm.gates/1", "gates": []}, "/"),
            ([], "[]"),
        ]:
            self.write("report.json", document)
            self.reject(["gate", "report.json", "--junit", "junit.xml"], "report.json", *named)

    def test_command_line(self):
        self.write("query.json", documents.query())
        for arguments in ([], ["elipse"], ["ellipse"], ["ellipse", "query.json", "--thread", "2"], ["ellipse", "query.json", "--threads", "many"],
                          ["ellipse", "query.json", "--seed", "-1"], ["ellipse", "query.json", "--threads", "-2"], ["render", "query.json"]):
            with self.subTest(arguments):
                before = snapshot(self.folder)
                process = sturm(*arguments, cwd=self.folder)
                self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)
                self.assertEqual(process.stdout, "")
                self.assertNotEqual(process.stderr, "")
                self.assertEqual(snapshot(self.folder), before)


if __name__ == "__main__":
    unittest.main()
