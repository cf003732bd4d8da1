"""Firefox by its own remote protocol, Marionette (https://firefox-source-docs.mozilla.org/testing/marionette/): what geckodriver, which Debian
does not have, would translate WebDriver's requests into."""
import json
import os
import shutil
import socket
import subprocess
import time

from webdriver import Browser

COMMANDS = {"/url": "WebDriver:Navigate", "/execute/sync": "WebDriver:ExecuteScript", "/element": "WebDriver:FindElement",
            "/actions": "WebDriver:PerformActions", "/window/rect": "WebDriver:SetWindowRect", "/timeouts": "WebDriver:SetTimeouts", "/screenshot": "WebDriver:TakeScreenshot"}
OF_ELEMENTS = {"click": "WebDriver:ElementClick", "text": "WebDriver:GetElementText", "value": "WebDriver:ElementSendKeys"}
PREFERENCES = {"marionette.port": 0, "ui.prefersReducedMotion": 1, "browser.shell.checkDefaultBrowser": False,
               "datareporting.policy.dataSubmissionEnabled": False, "app.update.disabledForTesting": True}
# Errors of the page's own scripts and styles; the browser's messages about itself are none of them.
ERRORS = """
  const seen = Services.console.getMessageArray().filter((m) => m instanceof Ci.nsIScriptError && /^(file:|http:..127.0.0.1)/.test(m.sourceName));
  Services.console.reset();
  return seen.map((m) => ({message: m.errorMessage}));"""

# The page within the window as large as a phone's screen; no size: as large as the window has room for.
AS_PHONE = """
  const {style} = gBrowser.selectedBrowser, [width, height] = arguments, px = (size) => (size ? `${size}px` : "");
  [style.minWidth, style.maxWidth, style.minHeight, style.maxHeight] = [px(width), px(width), px(height), px(height)];"""


def firefox():
    """Firefox' file, or None where it is not installed."""
    return shutil.which("firefox-esr") or shutil.which("firefox")


class Screen:
    """A screen in memory (Debian's package xvfb), on which Firefox draws by Mesa's software rasteriser: without one it has no WebGL."""

    def __init__(self, width, height):
        reading, writing = os.pipe()
        self._process = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
                                         pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:  # the number that Xvfb has chosen
            self.environment = {"DISPLAY": f":{answer.readline().strip()}", "LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe"}

    def close(self):
        self._process.terminate()
        self._process.wait(timeout=20)


class Firefox(Browser):
    """A Firefox with Browser's functions: headless, or on a screen of its own, where it has WebGL."""

    def __init__(self, profile, width=1280, height=1000, screen=False):
        profile.mkdir()
        (profile / "user.js").write_text("".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items()))
        self._screen = Screen(width + 100, height + 200) if screen else None
        self._process = subprocess.Popen([firefox(), *([] if screen else ["--headless"]), "--no-remote", "--marionette", "--remote-allow-system-access", "--profile", profile],
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                         env={**os.environ, "HOME": str(profile), **(self._screen.environment if screen else {})})
        self._socket, self._received, self._number = None, b"", 0
        try:
            self._socket = socket.create_connection(("127.0.0.1", self._port_of(profile / "MarionetteActivePort")), timeout=120)
            self._receive()  # the server's greeting
            self._send("WebDriver:NewSession", {})
            self._call("POST", "/window/rect", {"width": width, "height": height})
        except Exception:
            self._end()
            raise

    def _port_of(self, file):
        """The port that Firefox has chosen; it writes it down once it listens."""
        for _ in range(600):
            if file.exists() and file.read_text().strip():
                return int(file.read_text())
            if self._process.poll() is not None:
                break
            time.sleep(0.2)
        raise RuntimeError("Firefox does not start")

    def _receive(self):
        """One message: its length in bytes, a colon, JSON."""
        while b":" not in self._received:
            self._received += self._socket.recv(1 << 16)
        length, _, rest = self._received.partition(b":")
        while len(rest) < int(length):
            rest += self._socket.recv(1 << 16)
        self._received = rest[int(length):]
        return json.loads(rest[:int(length)])

    def _send(self, command, parameters):
        self._number += 1
        text = json.dumps([0, self._number, command, parameters]).encode()
        self._socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self._receive()
        if error:
            raise RuntimeError(f"{error['error']}: {error['message']}")
        return result["value"] if isinstance(result, dict) and set(result) == {"value"} else result

    def _call(self, method, path, body=None):
        parts = path.split("/")
        if len(parts) == 4:  # /element/REFERENCE/WHAT
            return self._send(OF_ELEMENTS[parts[3]], {"id": parts[2], **(body or {})})
        return self._send(COMMANDS[path], body or {})

    def _run_in_browser(self, script, *arguments):
        """As run(), in the browser's own window."""
        self._send("Marionette:SetContext", {"value": "chrome"})
        try:
            return self.run(script, *arguments)
        finally:
            self._send("Marionette:SetContext", {"value": "content"})

    def as_phone(self, width, height):
        self._run_in_browser(AS_PHONE, width, height)

    def console(self):
        return self._run_in_browser(ERRORS)

    def close(self):
        try:
            self._send("Marionette:Quit", {})
        finally:
            self._end()

    def _end(self):
        if self._socket:
            self._socket.close()
        try:
            self._process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._screen:
            self._screen.close()
