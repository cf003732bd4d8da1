"""`sturm view`: what it puts into a page, and what it says when it cannot."""
import math
import shutil
import subprocess
import unittest

from sturm_process import SOURCE, STURM, WRONG_INPUT, FolderTest, sturm
from viewer_page import TEMPLATE, Scene, content_of, view_of

DESK = SOURCE / "configs/views/desk.json"


class Page(FolderTest):
    def setUp(self):
        super().setUp()
        self.template = self.write("template.html", TEMPLATE)
        self.page = self.folder / "page.html"

    def view(self, document, *options):
        """The text of the page of a document or a file."""
        file = document if not isinstance(document, dict) else self.write("view.json", document)
        self.said = self.succeed("view", file, "-o", self.page, "--template", self.template, *options).stderr
        return self.page.read_text()

    def document(self, **changes):
        return {"format": "sturm.render/1", "eye": {"prescription": {"sphere_D": -2, "cylinder_D": -1.5, "axis_deg": 30}, "pupil_diameter_mm": 4},
                "scene": {"format": "sturm.scene/1", "materials": {"wall": {"albedo": [0.5, 0.25, 0.125]}, "lamp": {"emission": [3, 2, 1]}},
                          "meshes": [{"name": "</script>", "material": "wall", "positions_m": [[-1, -1, -2], [1, -1, -2], [1, 1, -2], [-1, 1, -2]],
                                      "faces": [[0, 1, 2, 3]]}],
                          "spheres": [{"center_m": [0, 0.75, -1.5], "radius_m": 0.125, "material": "lamp"}],
                          "lights": [{"type": "point", "position_m": [0, 0, 1], "intensity": [1, 1, 1]}], "environment": {"radiance": [0.5, 0.5, 1]}},
                "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [64, 48]},
                "method": {"type": "predict", "prediction": "multipass"}, **changes}

    def test_scene_comes_through(self):
        scene = Scene(self.view(self.document()))
        header = scene.header
        self.assertEqual(header["format"], "sturm.viewer_scene/1")
        self.assertEqual(scene.rows(header["positions"]), [[-1, -1, -2], [1, -1, -2], [1, 1, -2], [-1, 1, -2]])
        self.assertEqual(scene.rows(header["triangles"]), [[0, 1, 2], [0, 2, 3]])
        self.assertEqual(header["spheres"], [{"center_m": [0, 0.75, -1.5], "radius_m": 0.125, "material": header["spheres"][0]["material"]}])
        lamp = header["materials"][header["spheres"][0]["material"]]
        self.assertEqual((lamp["name"], lamp["emission"]), ("lamp", [3, 2, 1]))
        self.assertEqual(header["lights"], [{"position_m": [0, 0, 1], "intensity": [1, 1, 1]}])
        self.assertEqual(header["environment"], {"radiance": [0.5, 0.5, 1], "texture": None, "rotation_rad": 0})
        self.assertEqual(header["bounds_m"], {"lower": [-1, -1, -2], "upper": [1, 1, -1.375]})

    def test_view_has_the_document_and_its_numbers(self):
        lens = {"single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5, "base_curve_D": 4}}
        page = self.view(self.document(spectacles=lens, camera={
            "position_m": [0, 1, 0], "look_at_m": [0, 1, -1], "vfov_deg": 40, "resolution": [64, 48], "gaze": "foveal",
            "stereo": {"interpupillary_distance_mm": 63}}, left={"eye": {"prescription": "-1.00 DS", "pupil_diameter_mm": 3}}))
        view = view_of(page)
        self.assertEqual(view["format"], "sturm.viewer_view/1")
        self.assertEqual(view["view"]["camera"]["up"], [0, 1, 0])  # a default, spelt out
        self.assertEqual(view["camera"]["gaze"], "foveal")
        self.assertAlmostEqual(view["camera"]["vfov_rad"], math.radians(40), delta=1e-15)
        self.assertEqual(view["interpupillary_distance_m"], 0.063)
        right, left = view["right"], view["left"]
        self.assertEqual(right["eye"]["prescription"], {"sphere_D": -2, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_m": 0.012,
                                                        "prism_cm_per_m": 0, "prism_base_deg": 0})
        self.assertEqual(right["eye"]["pupil_diameter_m"], 0.004)
        self.assertEqual((right["lens"]["kind"], right["lens"]["base_curve_D"]), ("single_vision", 4))
        self.assertEqual(left["eye"]["prescription"]["sphere_D"], -1)
        # The left eye wears the right one's lens, as in `sturm render`.
        self.assertEqual(left["lens"]["prescription"]["cylinder_D"], -1.5)

    def test_names_within_a_script_do_not_end_it(self):
        page = self.view(self.document())
        self.assertEqual(page.count("</script>"), 2)
        self.assertNotIn("<", content_of(page, "sturm-view"))
        self.assertEqual(Scene(page).header["meshes"][0]["name"], "</script>")

    def test_pictures_of_the_desk_lose_nothing_and_the_page_is_the_same_again(self):
        page = self.view(DESK)
        scene = Scene(page)
        self.assertGreater(scene.header["triangles"]["count"], 1000)
        for texture in scene.header["textures"]:
            self.assertEqual(len(scene.texels(texture)), texture["width"] * texture["height"] * texture["channels"])
        self.assertEqual(page, self.view(DESK))

    def test_what_the_page_draws_otherwise_is_said(self):
        document = self.document()
        document["scene"]["materials"]["lamp"] = {"type": "seed_metal", "albedo": [1, 1, 1]}
        self.assertEqual(view_of(self.view(document))["not_drawn"], ['The material "lamp" is drawn as a diffuse one of the same colour.'])
        self.assertIn('note: The material "lamp"', self.said)
        self.view(document, "--quiet")
        self.assertEqual(self.said, "")

    def test_another_prescription_and_setting(self):
        view = view_of(self.view(self.document(), "--rx", "-4.00 DS", "--set", "/camera/vfov_deg=30"))
        self.assertEqual(view["right"]["eye"]["prescription"]["sphere_D"], -4)
        self.assertEqual(view["view"]["camera"]["vfov_deg"], 30)

    def refuse(self, document, expected, *options):
        process = sturm("view", self.write("view.json", document), "-o", self.page, *options)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn(expected, process.stderr)
        self.assertFalse(self.page.exists())

    def test_bad_input_leaves_nothing(self):
        template = ("--template", self.template)
        sphere = dict(self.document()["camera"], projection="equirectangular")
        del sphere["vfov_deg"]
        self.refuse({**self.document(), "camera": sphere, "method": {"type": "path_trace", "ray_model": "power_matrix"}}, "/camera/projection", *template)
        self.refuse(self.document(camera={}), "/camera", *template)
        self.refuse(self.document(), "places for a view and a scene", "--template", self.write("other.html", "<p>"))
        self.refuse(self.document(), "scripts/viewer", "--template", self.write("twice.html", TEMPLATE + TEMPLATE))
        self.refuse(self.document(), "none.html", "--template", self.folder / "none.html")
        process = sturm("view", DESK, "-o", self.folder / "page.txt", *template)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn(".html", process.stderr)

    def test_a_program_without_its_page_says_how_to_build_it(self):
        alone = self.folder / "alone/bin"
        alone.mkdir(parents=True)
        program = alone / "sturm"
        shutil.copy(STURM, program)
        process = subprocess.run([program, "view", DESK, "-o", self.page], capture_output=True, text=True)
        self.assertEqual(process.returncode, WRONG_INPUT)
        self.assertIn("scripts/viewer builds it", process.stderr)

    def test_the_script_says_what_it_takes_before_it_builds(self):
        script = self.folder / "scripts/viewer"  # alone: it could build nothing
        script.parent.mkdir()
        shutil.copy(SOURCE / "scripts/viewer", script)

        def run(*words):
            return subprocess.run([script, *words], capture_output=True, text=True)

        for word in ("--help", "-h"):
            process = run(word)
            self.assertEqual((process.returncode, process.stderr), (0, ""))
            self.assertIn("scripts/viewer [VIEW.json", process.stdout)
        for words, expected in ((["none.json"], "none.json: no such file"), (["--quiet"], '"--quiet" comes before a view')):
            process = run(*words)
            self.assertEqual((process.returncode, process.stdout), (WRONG_INPUT, ""))
            self.assertIn(expected, process.stderr)


if __name__ == "__main__":
    unittest.main()
