"""The button that asks the program for the same picture: against `sturm serve`, and against a server that gives any answer."""
import base64
import http.server
import json
import subprocess
import threading

from page_in_browser import TEMPLATE, PageTest, emissive_view, main
from sturm_process import STURM

# One white pixel.
PNG = "data:image/png;base64," + base64.b64encode(bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108000000003a7e9b55" "0000000a49444154789c63f80f00010101001bb6ee56" "0000000049454e44ae426082")).decode()


class Answers(http.server.BaseHTTPRequestHandler):
    page, asked, lines, status = b"", [], [], 200

    def log_message(self, *_):
        pass

    def send(self, status, kind, body):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        if self.path == "/status":
            self.send(200, "application/json", b'{"program": "sturm"}')
        else:
            self.send(200 if self.path == "/" else 404, "text/html", self.page if self.path == "/" else b"")

    def do_POST(self):
        Answers.asked.append(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send(Answers.status, "application/x-ndjson", b"".join(json.dumps(line).encode() + b"\n" for line in Answers.lines))


BUTTON = "[...document.querySelectorAll('button')].find((b) => b.textContent === 'Render this natively')"


class Program(PageTest):
    def test_the_program_draws_what_the_page_shows(self):
        document = self.folder / "view.json"
        document.write_text(json.dumps(emissive_view(64)))
        program = subprocess.Popen([STURM, "serve", document, "--template", TEMPLATE, "--quiet"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.terminate)
        self.browser.visit(program.stdout.readline().strip())
        self.wait(f"window.sturmViewer && !{BUTTON}.hidden && window.sturmViewer.app.panels[0]?.passes >= 64")
        self.browser.run(f"{BUTTON}.click()")
        self.wait("document.querySelector('#native img, #native .error')")
        self.browser.console()  # a favicon is the browser's own wish
        similarity = float(self.browser.text("#native").split("SSIM ")[1].split()[0].rstrip(",.;"))
        self.assertGreater(similarity, 0.98)  # rasterised passes of glowing rectangles


class AnyAnswer(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.write_page(cls(), emissive_view(64))
        Answers.page = cls.page.read_bytes()
        cls.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Answers)
        threading.Thread(target=cls.server.serve_forever, daemon=True).start()
        cls.addClassCleanup(cls.server.server_close)
        cls.addClassCleanup(cls.server.shutdown)

    def press(self, status, *lines):
        Answers.status, Answers.lines = status, lines
        Answers.asked.clear()
        self.browser.visit(f"http://127.0.0.1:{self.server.server_port}/")
        self.wait(f"window.sturmViewer && !{BUTTON}.hidden && window.sturmViewer.app.panels[0]?.passes > 0")
        self.browser.run(f"{BUTTON}.click()")
        self.wait("document.querySelector('#native img, #native .error')")
        # A favicon is the browser's own wish.
        self.browser.console()

    def test_a_file_has_no_button(self):
        self.browser.open(self.page)
        self.wait("window.sturmViewer")
        self.assertTrue(self.browser.run(f"return {BUTTON}.hidden"))

    def test_what_is_asked_and_what_is_shown(self):
        comparison = {"ssim": 0.98765, "flip": 0.0123, "rmse_display": 0.004, "flip_map": PNG}
        self.press(200, {"progress": 0.5, "seconds": 1.0}, {"picture": PNG, "seconds": 2.0, "notes": ["A note."], "comparison": comparison})
        self.assertIn("SSIM 0.9877", self.browser.text("#native"))
        self.assertIn("A note.", self.browser.text("#native"))
        asked, = Answers.asked
        self.assertEqual(asked["view"]["eye"]["prescription"], {"sphere_D": -6, "cylinder_D": -3, "axis_deg": 30, "vertex_distance_mm": 0})
        self.assertEqual(asked["view"]["camera"]["resolution"], [64, 64])
        self.assertTrue(asked["picture"].startswith("data:image/png;base64,"))

    def test_errors_are_shown(self):
        self.press(200, {"progress": 0.1, "seconds": 0.2}, {"error": "/eye: no."})
        self.assertEqual(self.browser.text("#native"), "/eye: no.")
        self.press(503, {"error": "Another picture is rendered."})
        self.assertEqual(self.browser.text("#native"), "Another picture is rendered.")
        self.press(200)
        self.assertEqual(self.browser.text("#native"), "The program ended without a picture.")


if __name__ == "__main__":
    main()
