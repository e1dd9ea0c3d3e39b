"""A headless chromium behind chromedriver, spoken to as W3C WebDriver says, and what a test says of what it sees."""
import base64
import json
import subprocess
import sys
import time
import urllib.error
import urllib.request

DRIVER_PORT = 9515
STARTED = []   # Every process, for the end whatever happens.
SESSIONS = []  # Of the browser, likewise.


def spawn(words, **streams):
    STARTED.append(subprocess.Popen(words, **streams))
    return STARTED[-1]


def end_everything():
    for session in SESSIONS:
        try:
            Browser.request("DELETE", session)
        except OSError:
            pass  # It was ended before, or the driver is gone.
    for process in STARTED:
        if process.poll() is None:
            process.terminate()
            process.wait(timeout=20)


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(77)


def fail(reason):
    print(f"FAILED: {reason}")
    sys.exit(1)


def check(condition, reason):
    if not condition:
        fail(reason)
    print(f"ok: {reason}", flush=True)


def start_driver():
    spawn(["chromedriver", f"--port={DRIVER_PORT}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for _ in range(100):
        try:
            return Browser.request("GET", "/status")
        except (OSError, urllib.error.URLError):
            time.sleep(0.2)
    return fail("chromedriver does not answer")


class Browser:
    """One session."""

    def __init__(self, folder):
        options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                   "--window-size=1280,860", f"--user-data-dir={folder}"]
        answer = self.post("/session", {"capabilities": {"alwaysMatch": {"goog:chromeOptions": {"args": options}}}})
        self.session = "/session/" + answer["sessionId"]
        SESSIONS.append(self.session)

    @staticmethod
    def request(method, path, body=None):
        request = urllib.request.Request(f"http://127.0.0.1:{DRIVER_PORT}{path}", method=method,
                                         data=None if body is None else json.dumps(body).encode(),
                                         headers={"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["value"]

    @classmethod
    def post(cls, path, body):
        return cls.request("POST", path, body)

    def go(self, url):
        self.post(self.session + "/url", {"url": url})

    def run(self, script):
        return self.post(self.session + "/execute/sync", {"script": script, "args": []})

    def wait(self, script, what, seconds=30):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = self.run(script)
            if value:
                print(f"ok: {what}", flush=True)
                return value
            time.sleep(0.2)
        return fail(f"within {seconds} s: {what}")

    def element(self, css):
        return next(iter(self.post(self.session + "/element", {"using": "css selector", "value": css}).values()))

    def click(self, css):
        self.post(f"{self.session}/element/{self.element(css)}/click", {})

    def click_at(self, x, y):
        """A click of the mouse at a place of the window."""
        at = {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)}
        self.post(self.session + "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [
            at, {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}]})

    def pinch(self, x, y, before, after):
        """Two fingers about a place of the window, so far apart before and after [pixels]."""
        def finger(name, side):
            at = [{"type": "pointerMove", "duration": 50, "x": round(x + side * width / 2), "y": round(y)} for width in (before, after)]
            return {"type": "pointer", "id": name, "parameters": {"pointerType": "touch"},
                    "actions": [at[0], {"type": "pointerDown", "button": 0}, at[1], {"type": "pointerUp", "button": 0}]}
        self.post(self.session + "/actions", {"actions": [finger("left", -1), finger("right", 1)]})

    def screenshot(self, path):
        path.write_bytes(base64.b64decode(self.request("GET", self.session + "/screenshot")))

    def quit(self):
        SESSIONS.remove(self.session)
        self.request("DELETE", self.session)
