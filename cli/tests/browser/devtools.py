"""Drives a Chromium of this machine over its DevTools protocol. Nothing is downloaded."""

import json
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import websocket

#: Names under which systems have the browser.
NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")

# Starts that are tried, and the time of each.
STARTS, SECONDS = 3, 40


def browser_path() -> str | None:
    """Path of the browser: that of the variable CHROMIUM, or of the first known name."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """A headless browser with one page."""

    def __init__(self, path: str) -> None:
        port, place = self._started(path)
        self.count = 0
        self.faults: list[str] = []
        self.requests: list[str] = []
        self.session: str | None = None
        self.loaded = False
        self.socket = websocket.create_connection(f"ws://127.0.0.1:{port}{place}", suppress_origin=True, timeout=60)
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def _started(self, path: str) -> list[str]:
        """Starts the browser. Returns port and path of its socket. On a busy machine a start may hang: then it is tried again."""
        for _ in range(STARTS):
            self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
            options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--remote-debugging-port=0",
                       "--disable-background-networking", "--disable-component-update", "--hide-scrollbars",
                       f"--user-data-dir={self.folder.name}", "about:blank"]
            self.process = subprocess.Popen([path, *options], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            file = Path(self.folder.name) / "DevToolsActivePort"
            for _ in range(10 * SECONDS):
                if file.exists() and len(lines := file.read_text().split()) == 2:
                    return lines
                time.sleep(0.1)
            self.process.kill()
            self.process.wait()
        raise RuntimeError(f"the browser has opened no port in {STARTS} starts of {SECONDS} s")

    def call(self, method: str, **parameters):
        """Result of a command; what the browser tells meanwhile is noted."""
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        self.socket.send(json.dumps(message))
        while True:
            answer = json.loads(self.socket.recv())
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self._note(answer.get("method"), answer.get("params", {}))

    def _note(self, method: str | None, told: dict) -> None:
        if method == "Runtime.exceptionThrown":
            details = told["exceptionDetails"]
            self.faults.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and told["type"] in ("error", "warning", "assert"):
            self.faults.append(" ".join(str(part.get("value", part.get("description"))) for part in told["args"]))
        elif method == "Log.entryAdded" and told["entry"]["level"] in ("error", "warning"):
            self.faults.append(told["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(told["request"]["url"])
        elif method == "Page.loadEventFired":
            self.loaded = True

    def run(self, script: str):
        """Value of an expression in the page; promises are waited for."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{script}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def open(self, file: Path) -> None:
        """Opens a file."""
        self.visit(file.resolve().as_uri())

    def visit(self, url: str) -> None:
        """Opens a page and waits until it is loaded; faults and requests are those of this page from now on."""
        self.faults, self.requests, self.loaded = [], [], False
        self.call("Page.navigate", url=url)
        for _ in range(200):
            if self.loaded:
                return
            self.run("new Promise((done) => setTimeout(done, 50))")
        raise RuntimeError(f"{url} is not loaded after 10 s")

    def key(self, key: str, code: int) -> None:
        """Presses a key."""
        text = {"text": " "} if key == " " else {}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, **text)

    def click(self, x: float, y: float) -> None:
        """Clicks at a place of the window."""
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def screen(self, width: int, height: int) -> None:
        """Gives the window a size, as a phone's."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def colours(self, scheme: str) -> None:
        """Asks pages for "light" or "dark" colours."""
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def picture(self, file: Path) -> None:
        """Writes what the window shows as PNG."""
        import base64

        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", captureBeyondViewport=True)["data"]))

    def __enter__(self) -> "Browser":
        return self

    def __exit__(self, *_) -> None:
        self.session = None
        try:
            self.call("Browser.close")
        except (OSError, RuntimeError, websocket.WebSocketException):
            self.process.kill()
        self.process.wait(30)
        self.folder.cleanup()
