"""`sturm validate-camera`: this program's own cameras pass, as others' would; wrong cameras fail."""
import json
import math
import struct
import unittest
import xml.etree.ElementTree

from sturm_process import FAILED, PASSED, WRONG_INPUT, FolderTest, strict_json, sturm


class Camera(FolderTest):
    def write_scene(self, *options):
        self.succeed("validate-camera", self.folder / "check", "--write", *options)
        return strict_json((self.folder / "check/expected.json").read_text())

    def render(self, name="picture.exr", **changes):
        arguments = [part for pointer, value in changes.items() for part in ("--set", f"/{pointer.replace('__', '/')}={json.dumps(value)}")]
        self.succeed("render", self.folder / "check/view.json", "-o", self.folder / "check" / name, "--quiet", *arguments, timeout=300)

    def judge(self, *options):
        return sturm("validate-camera", self.folder / "check", *options)


class Scene(Camera):
    def test_what_is_expected_of_a_thin_lens(self):
        check = self.write_scene("--pupil", 6, "--focus", 1)
        self.succeed("validate", self.folder / "check/expected.json")
        self.succeed("validate", self.folder / "check/view.json")
        camera = strict_json((self.folder / "check/camera.json").read_text())
        self.assertEqual(camera["thin_lens"], {"aperture_radius_m": 0.003, "focus_distance_m": 1.0})
        pixel = 2 * math.tan(math.radians(check["vfov_deg"]) / 2) / check["resolution"][1]
        for lamp in check["lamps"]:
            x, y, z = lamp["position_m"]
            radius = 0.003 * abs(-1 / z - 1) / pixel  # similar triangles
            for axis, arcmin in zip(lamp["semi_axes_px"], lamp["semi_axes_arcmin"]):
                self.assertAlmostEqual(axis, radius, delta=1e-9)
                self.assertAlmostEqual(arcmin, 3437.7467707849 * pixel * radius, delta=1e-9)  # 60 * 180 / pi
            column, row = lamp["centroid_px"]
            self.assertAlmostEqual(column, check["resolution"][0] / 2 + x / -z / pixel, delta=1e-9)
            self.assertAlmostEqual(row, check["resolution"][1] / 2 - y / -z / pixel, delta=1e-9)
            self.assertLess(radius, check["window_px"])

    def test_the_gltf_file_has_the_lamps_and_the_camera(self):
        check = self.write_scene()
        gltf = strict_json((self.folder / "check/scene.gltf").read_text())
        data = (self.folder / "check/scene.bin").read_bytes()
        self.assertEqual(len(data), gltf["buffers"][0]["byteLength"])
        for lamp, mesh in zip(check["lamps"], gltf["meshes"]):
            accessor = gltf["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]
            corners = [struct.unpack_from("<3f", data, accessor["byteOffset"] + 12 * k) for k in range(4)]
            for axis in range(3):
                self.assertAlmostEqual(sum(c[axis] for c in corners) / 4, lamp["position_m"][axis], delta=1e-6 * abs(lamp["position_m"][2]))
            self.assertAlmostEqual(corners[1][0] - corners[0][0], lamp["side_m"], delta=1e-5 * lamp["side_m"] + 1e-6)
        self.assertEqual(gltf["cameras"][0]["perspective"]["yfov"], math.radians(check["vfov_deg"]))

    def test_what_is_wrong(self):
        self.write_scene()
        self.assertEqual(self.judge().returncode, WRONG_INPUT)  # no picture yet
        self.assertEqual(sturm("validate-camera", self.folder / "nowhere").returncode, WRONG_INPUT)
        self.assertEqual(sturm("validate-camera", self.folder / "x", "--write", "--focus", 0).returncode, WRONG_INPUT)


class Pictures(Camera):
    def test_a_thin_lens(self):
        self.write_scene()
        self.render(method__ray_model="thin_lens")
        process = self.judge("--junit", self.folder / "j.xml", "--markdown", self.folder / "s.md")
        self.assertEqual(process.returncode, PASSED, process.stdout)
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "j.xml").getroot().get("failures"), "0")
        # Mutants: a pupil that is 10 % too large, and a picture of another focus.
        self.render(method__ray_model="thin_lens", eye__pupil_diameter_mm=6.6)
        self.assertEqual(self.judge().returncode, FAILED)
        self.render(method__ray_model="thin_lens", eye__accommodation__focus_distance_m=1.1)
        self.assertEqual(self.judge().returncode, FAILED)

    def test_a_camera_with_a_cylinder(self):
        self.write_scene("--rx", "-1.00 -2.00 x 30", "--pupil", 5)
        self.render()
        self.assertEqual(self.judge().returncode, PASSED, self.judge().stdout)
        # Of the farthest lamp, at 20 m, another sphere of the same sum with the cylinder changes the short axis alone.
        self.render(eye__prescription="-1.30 -1.70 x 30")
        process = self.judge()
        self.assertIn("FAIL  lamp7/semi_axes", process.stdout)
        # A mirrored axis leaves the size of every spot as it is.
        self.render(eye__prescription="-1.00 -2.00 x 150")
        process = self.judge("--markdown", self.folder / "s.md")
        self.assertEqual(process.returncode, FAILED)
        failed = [line.split()[1] for line in process.stdout.splitlines() if line.startswith("FAIL")]
        self.assertTrue(failed and all(name.endswith("/orientation") for name in failed), failed)
        self.assertIn("✗", (self.folder / "s.md").read_text())

    def test_a_picture_of_another_size_or_of_nothing(self):
        self.write_scene()
        self.render(camera__resolution=[64, 64], method__samples_per_pixel=1)
        self.assertEqual(self.judge().returncode, WRONG_INPUT)
        self.render(camera__look_at_m=[0, 0, 1], method__samples_per_pixel=1)
        self.assertEqual(self.judge().returncode, FAILED)


if __name__ == "__main__":
    unittest.main()
