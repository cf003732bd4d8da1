"""`sturm serve`: a page on the loopback address, and pictures that it asks for, with progress and comparison."""
import base64
import contextlib
import http.client
import json
import math
import re
import subprocess
import time
import unittest

import documents
import png_pixels
from sturm_process import STURM, WRONG_INPUT, FolderTest, sturm

PAGE = """<!doctype html><title>A page</title>
<script id="sturm-view" type="application/json">null</script><script id="sturm-scene" type="text/plain"></script>"""


class Serve(FolderTest):
    def setUp(self):
        super().setUp()
        self.view = documents.view()
        self.view["camera"]["resolution"] = [48, 32]
        self.view["method"]["samples_per_pixel"] = 4
        file = self.write("view.json", self.view)
        page = self.write("page.html", PAGE)
        self.process = subprocess.Popen([STURM, "serve", file, "--template", page], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        address = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\n", self.process.stdout.readline())
        self.port = int(address[1])

    def stop(self):
        self.process.terminate()
        self.process.communicate(timeout=60)

    def ask(self, method, path, body=None, **headers):
        """(status, text) of an answer; a keyword Content_Type is the header Content-Type."""
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=100)) as connection:
            connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
            response = connection.getresponse()
            return response.status, response.read().decode()

    def render(self, request, **headers):
        return self.ask("POST", "/render", json.dumps(request), **{"Content_Type": "application/json", **headers})

    def lines(self, request):
        status, text = self.render(request)
        self.assertEqual(status, 200, text)
        return [json.loads(line) for line in text.splitlines()]

    def test_page_and_status(self):
        self.succeed("view", self.folder / "view.json", "-o", self.folder / "view.html", "--template", self.folder / "page.html", "--quiet")
        self.assertEqual(self.ask("GET", "/"), (200, (self.folder / "view.html").read_text()))
        status, text = self.ask("GET", "/status")
        self.assertEqual((status, json.loads(text)["program"], json.loads(text)["busy"]), (200, "sturm", False))
        self.assertEqual(self.ask("GET", "/etc/passwd")[0], 404)
        self.assertEqual(self.ask("GET", "/", Host=f"localhost:{self.port}")[0], 200)

    def test_a_browser_keeps_nothing_and_guesses_no_type(self):
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=100)) as connection:
            for path in ("/", "/status", "/nothing"):
                connection.request("GET", path)
                response = connection.getresponse()
                response.read()
                self.assertEqual((response.getheader("X-Content-Type-Options"), response.getheader("Cache-Control")), ("nosniff", "no-store"), path)

    def test_picture_is_that_of_render(self):
        self.succeed("render", self.folder / "view.json", "-o", self.folder / "native.exr")
        *progress, last = self.lines({"view": self.view})
        for before, after in zip(progress, progress[1:]):
            self.assertLessEqual(before["progress"], after["progress"])
        self.assertIsNone(last["comparison"])
        png = base64.b64decode(last["picture"].removeprefix("data:image/png;base64,"))
        self.assertEqual(png_pixels.decode(png), png_pixels.decode((self.folder / "native.png").read_bytes()))

    def test_comparison_is_that_of_compare(self):
        first = self.lines({"view": self.view})[-1]["picture"]
        other = {**self.view, "seed": 7}
        last = self.lines({"view": other, "picture": first})[-1]
        for name, picture in {"page.png": first, "native.png": last["picture"]}.items():
            self.write(name, base64.b64decode(picture.split(",")[1]))
        # A degree at the middle of 32 rows over the field of view; PNG files do not tell it.
        per_degree = math.radians(1) * 16 / math.tan(math.radians(self.view["camera"]["vfov_deg"] / 2))
        compared = json.loads(self.succeed("compare", self.folder / "page.png", self.folder / "native.png", "--pixels-per-degree", per_degree, "--json", "-").stdout)
        for name, key in (("ssim", "ssim_display"), ("flip", "flip"), ("rmse_display", "rmse_display")):
            self.assertAlmostEqual(last["comparison"][name], compared["metrics"][key], delta=2e-3)  # the file's is of 8 bits
        self.assertLess(last["comparison"]["ssim"], 0.99)  # another seed: there is something to compare
        self.assertTrue(last["comparison"]["flip_map"].startswith("data:image/png;base64,"))
        same = self.lines({"view": self.view, "picture": first})[-1]["comparison"]
        self.assertLessEqual(same["rmse_display"], 0.5 / 255)  # what 8 bits round

    def test_requests_of_others_are_refused(self):
        self.assertEqual(self.ask("GET", "/", Host="evil.example")[0], 403)
        self.assertEqual(self.ask("GET", "/", Host=f"127.0.0.1.evil.example:{self.port}")[0], 403)
        self.assertEqual(self.render({"view": self.view}, Origin="http://evil.example")[0], 403)
        self.assertEqual(self.render({"view": self.view}, Origin="null")[0], 403)
        self.assertEqual(self.render({"view": self.view}, Content_Type="text/plain")[0], 415)
        self.assertEqual(self.render({"view": self.view}, Origin=f"http://127.0.0.1:{self.port}")[0], 200)

    def test_wrong_views_are_explained(self):
        for body, expected in {"[": "<request>", "{}": "/view", json.dumps({"view": {**self.view, "eye": "/etc/passwd"}}): "--sandbox"}.items():
            status, text = self.ask("POST", "/render", body, Content_Type="application/json")
            self.assertEqual(status, 400, text)
            self.assertIn(expected, json.loads(text)["error"])
        self.view["camera"]["resolution"] = [20000, 20000]
        self.assertIn("/camera/resolution", self.render({"view": self.view})[1])

    def test_one_picture_at_a_time_and_none_for_nobody(self):
        self.view["camera"]["resolution"], self.view["method"]["samples_per_pixel"] = [1600, 1600], 256
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=100)
        connection.request("POST", "/render", json.dumps({"view": self.view}), {"Content-Type": "application/json"})
        response = connection.getresponse()
        self.assertIn("progress", json.loads(response.readline()))
        self.assertTrue(json.loads(self.ask("GET", "/status")[1])["busy"])
        self.assertEqual(self.render({"view": self.view})[0], 503)
        response.close()
        connection.close()
        end = time.monotonic() + 60
        while json.loads(self.ask("GET", "/status")[1])["busy"] and time.monotonic() < end:
            time.sleep(0.1)
        self.assertFalse(json.loads(self.ask("GET", "/status")[1])["busy"])

    def test_the_next_picture_may_be_asked_for_at_once(self):
        self.view["camera"]["resolution"], self.view["method"]["samples_per_pixel"] = [12, 8], 1
        self.assertEqual([self.render({"view": self.view})[0] for _ in range(100)], [200] * 100)

    def test_a_port_that_is_taken(self):
        process = sturm("serve", self.folder / "view.json", "--template", self.folder / "page.html", "--port", self.port)
        self.assertEqual(process.returncode, 3, process.stderr)
        self.assertIn(str(self.port), process.stderr)

    def test_wrong_documents_end_it_at_once(self):
        self.view["eye"] = {}
        process = sturm("serve", self.write("wrong.json", self.view), "--template", self.folder / "page.html")
        self.assertEqual(process.returncode, WRONG_INPUT, process.stderr)


if __name__ == "__main__":
    unittest.main()
