"""A browser by the W3C WebDriver protocol (https://www.w3.org/TR/webdriver2/), through Debian's chromedriver and Chromium."""
import base64
import http.client
import json
import shutil
import subprocess

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the protocol's name for a reference to an element
KEYS = {"left": "\ue012", "up": "\ue013", "right": "\ue014", "down": "\ue015", "shift": "\ue008", "tab": "\ue004", "enter": "\ue007", "space": "\ue00d"}


class Browser:
    """A headless window of a given size; close() ends it. `switches`: further words of Chromium's command line."""

    def __init__(self, profile, width=1280, height=1000, switches=()):
        driver = shutil.which("chromedriver")
        if not driver or not shutil.which("chromium"):
            raise RuntimeError("Debian's packages chromium and chromium-driver are not installed (scripts/dependencies.txt)")
        self._process = subprocess.Popen([driver, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self._port = None
        for line in self._process.stdout:  # "ChromeDriver was started successfully on port N."
            if "successfully on port" in line:
                self._port = int(line.rstrip(". \n").rsplit(" ", 1)[1])
                break
        self._session = ""
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--force-prefers-reduced-motion", "--no-first-run",
                            f"--user-data-dir={profile}", f"--window-size={width},{height}", *switches]}
        try:
            capabilities = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
            session = self._call("POST", "", {"capabilities": {"alwaysMatch": capabilities}})
        except Exception:
            self._process.terminate()
            raise
        self._session = "/" + session["sessionId"]

    def _call(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self._port, timeout=120)
        text = None if method == "GET" else json.dumps(body or {})
        connection.request(method, "/session" + self._session + path, text, {"Content-Type": "application/json"})
        value = json.loads(connection.getresponse().read())["value"]
        connection.close()
        if isinstance(value, dict) and "error" in value:
            raise RuntimeError(f"{value['error']}: {value['message']}")
        return value

    @property
    def process(self):
        """The number of the process that all of the browser comes from."""
        return self._process.pid

    def open(self, path):
        self.visit(path.as_uri())

    def visit(self, address):
        self._call("POST", "/url", {"url": address})

    def run(self, script, *arguments):
        """Runs the body of a JavaScript function in the page; returns its result."""
        return self._call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def allow_scripts(self, seconds):
        """How long a script of run() may take; 30 s before this is called."""
        self._call("POST", "/timeouts", {"script": round(1000 * seconds)})

    def resize(self, width, height):
        self._call("POST", "/window/rect", {"width": width, "height": height})

    def as_phone(self, width, height):
        """Shows the page as a phone of this size would; no size ends that."""
        override = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": True}
        self._call("POST", "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride" if width else "Emulation.clearDeviceMetricsOverride", "params": override if width else {}})

    def find(self, selector):
        return self._call("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector):
        self._call("POST", f"/element/{self.find(selector)}/click")

    def text(self, selector):
        return self._call("GET", f"/element/{self.find(selector)}/text")

    def type(self, selector, text):
        self._call("POST", f"/element/{self.find(selector)}/value", {"text": text})

    def press(self, selector, *keys):
        """Gives an element the focus, then presses and releases keys."""
        self.run("document.querySelector(arguments[0]).focus()", selector)
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self._call("POST", "/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def pointer(self, selector, *moves):
        """Moves of the mouse relative to an element's centre [px]; "down" and "up" press and release its button. A browser's mouse stays where it is
        when another page opens: a move to the same place is none."""
        origin = {ELEMENT: self.find(selector)}
        self.run("document.querySelector(arguments[0]).scrollIntoView({block: 'center'})", selector)
        actions = [{"type": "pointerDown" if move == "down" else "pointerUp", "button": 0} if isinstance(move, str) else
                   {"type": "pointerMove", "duration": 0, "origin": origin, "x": move[0], "y": move[1]} for move in moves]
        self._call("POST", "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": actions}]})
        # Moves reach the page with its next frame.
        self.run("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))));")

    def screenshot(self):
        """The visible part of the page as bytes of a PNG file."""
        return base64.b64decode(self._call("GET", "/screenshot"))

    def screenshot_of(self, selector):
        """The same of one element, all of it."""
        return base64.b64decode(self._call("GET", f"/element/{self.find(selector)}/screenshot"))

    def console(self):
        """Messages of the page's console and errors of its scripts since the last call."""
        return self._call("POST", "/se/log", {"type": "browser"})

    def close(self):
        try:
            self._call("DELETE", "")
        finally:
            self._process.terminate()
            self._process.wait(timeout=20)
            self._process.stdout.close()
