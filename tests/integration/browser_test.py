#!/usr/bin/python3
"""The browser view in a real browser: live traffic at 20 Hz, then the log of it.

usage: browser_test.py LOOKOUT SCENARIO [--screenshot FILE.png]

Runs simulator, tracker, logger and `lookout watch` over UDP multicast in a network namespace of its own, and a headless
chromium that a test drives through chromedriver. Status 77 where this machine cannot run it; `tools/setup --with-browser`
installs what is needed.
"""
import base64
import json
import math
import os
import pathlib
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

URL = "udpm://239.255.76.67:7667?ttl=0"
WATCH_PORT, LOG_PORT, DRIVER_PORT = 8080, 8081, 9515
SPEED = 10              # Times real time: 20 scans a second of a sonar with a period of 0.5 s.
LISTEN_S = 20
LARGEST_ERROR_M = 3.0   # Of a confirmed track where there is a target.
FEWEST_TARGETS = 40     # Looked at in that time: ten looks at four targets, on a machine that does other things.
LARGEST_LOAD = 0.15     # Of a core, by the program.
LATENCY_RATIO = 1.05
LATENCY_PAIRS = 6       # Runs with and without a watcher, in turn: the machine does other things as well.


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
    print(f"ok: {reason}")


class Browser:
    """One session of chromedriver, spoken to as W3C WebDriver says."""

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

    def wait(self, script, what, seconds=15):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = self.run(script)
            if value:
                print(f"ok: {what}")
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

    def screenshot(self, path):
        path.write_bytes(base64.b64decode(self.request("GET", self.session + "/screenshot")))

    def quit(self):
        SESSIONS.remove(self.session)
        self.request("DELETE", self.session)


def inside_namespace():
    if os.environ.get("LOOKOUT_BROWSER_TEST") == "inside":
        return
    for tool in ("chromium", "chromedriver", "lcm-logger"):
        if not shutil.which(tool):
            skip(f"{tool} is not installed (tools/setup --with-browser)")
    if subprocess.run(["unshare", "-rn", "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        skip("no private network namespace (unshare -rn) here")
    os.environ["LOOKOUT_BROWSER_TEST"] = "inside"
    setup = 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@"'
    os.execvp("unshare", ["unshare", "-rn", "sh", "-c", setup, sys.executable, *sys.argv])


class Chain:
    """Simulator, tracker and logger of their own for a while."""

    def __init__(self, lookout, scenario, log=None, seconds=120):
        self.started = []
        if log:
            self.start(["lcm-logger", "--quiet", f"--lcm-url={URL}", str(log)])
            time.sleep(0.5)
        # The quick tracker: what is tested is what is shown.
        self.tracker = self.start([lookout, "track", "--tracker", "gnn", "--lcm-url", URL])
        self.simulator = self.start([lookout, "sim", scenario, "--wait-for", "1", "--speed", str(SPEED), "--lcm-url", URL,
                                     "--duration", str(seconds)])

    def start(self, words):
        self.started.append(spawn(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True))
        return self.started[-1]

    def stop(self):
        """Ends all; what the tracker said."""
        for process in reversed(self.started):
            process.send_signal(signal.SIGINT)
        said = {process: process.communicate(timeout=20)[1] for process in self.started}
        return said[self.tracker]


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def start_watch(lookout, words, port):
    process = spawn([lookout, "watch", *words, "--http", str(port), "--lcm-url", URL], stderr=subprocess.PIPE)
    for _ in range(100):
        try:
            urllib.request.urlopen(f"http://127.0.0.1:{port}/mode", timeout=2).close()
            return process
        except OSError:
            time.sleep(0.1)
    return fail("lookout watch does not answer")


def stalled_client():
    """A browser that asks for the stream and never reads."""
    return streaming_client(receive_buffer=4096)


def streaming_client(receive_buffer=100_000):
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
    client.connect(("127.0.0.1", WATCH_PORT))
    client.sendall(b"GET /events HTTP/1.1\r\nHost: x\r\n\r\n")
    return client


ERRORS = """
  const tracks = lookout.picture.tracks, truth = lookout.picture.truth;
  if (!tracks || !truth || tracks.utime !== truth.utime) return null;
  return truth.targets.filter((t) => t.visible).map((t) => Math.min(...tracks.tracks
    .filter((k) => k.status === 'confirmed').map((k) => Math.hypot(k.north - t.north, k.east - t.east))));
"""


def watch_tracks(browser):
    """The errors [m] of the tracks that the page holds, of every visible target, over LISTEN_S."""
    errors = []
    end = time.monotonic() + LISTEN_S
    while time.monotonic() < end:
        errors += [error for error in browser.run(ERRORS) or [] if error is not None]
        time.sleep(0.1)
    return errors


def choose_a_track(browser):
    place = browser.wait("""
      const track = lookout.picture.tracks && lookout.picture.tracks.tracks.find((k) => k.status === 'confirmed'
        && (lookout.trails.get(k.id) || []).length > 3);
      if (!track) return null;
      const box = document.getElementById('map').getBoundingClientRect(), at = lookout.map.toScreen(track.north, track.east);
      return [box.left + at[0], box.top + at[1], track.id];""", "a confirmed track with a trail is drawn")
    browser.click_at(place[0], place[1])
    browser.wait("return !document.getElementById('chosen').hidden && "
                 "/points over/.test(document.getElementById('history-text').textContent)", "a click on a track shows its history")
    colour = browser.run(f"""
      const at = lookout.map, track = lookout.picture.tracks.tracks.find((k) => k.id === {place[2]});
      if (!track) return null;
      at.draw(lookout.picture, lookout.trails, null);
      const [x, y] = at.toScreen(track.north, track.east), r = window.devicePixelRatio || 1;
      return Array.from(at.context.getImageData(Math.round(x * r), Math.round(y * r), 1, 1).data);""")
    check(colour is None or colour[1] > 150, f"the track is drawn where it is: {colour}")


def watch_live(lookout, scenario, folder, screenshot):
    log = folder / "log"
    watch = start_watch(lookout, [], WATCH_PORT)
    chain = Chain(lookout, scenario, log)
    browser, second = Browser(folder / "a"), Browser(folder / "b")
    stalled = stalled_client()
    browser.go(f"http://127.0.0.1:{WATCH_PORT}/")
    second.go(f"http://127.0.0.1:{WATCH_PORT}/")
    browser.wait("return lookout.picture.scan && lookout.picture.tracks", "the page loads and hears scans and tracks")
    begin, used = time.monotonic(), cpu_seconds(watch.pid)
    events = browser.run("return lookout.state.events")
    choose_a_track(browser)
    errors = watch_tracks(browser)
    load = (cpu_seconds(watch.pid) - used) / (time.monotonic() - begin)
    rate = (browser.run("return lookout.state.events") - events) / (time.monotonic() - begin)
    near = sum(error < LARGEST_ERROR_M for error in errors)
    print(f"   {len(errors)} targets seen, {near} of them with a track within {LARGEST_ERROR_M} m; load {load:.3f}; {rate:.0f} events/s")
    check(len(errors) >= FEWEST_TARGETS and near > 0.9 * len(errors), "tracks stand where the targets are")
    check(load < LARGEST_LOAD, f"the program takes less than {LARGEST_LOAD} of a core with two browsers and a stalled one")
    check(rate > SPEED, "events come as fast as the scans")
    check(second.run("return lookout.state.events") > 100, "a second browser sees it as well")
    if screenshot:
        browser.click("#pause")
        browser.screenshot(screenshot)
        browser.click("#pause")
    browser.click("#pause")
    frozen = browser.run("return lookout.picture.scan.utime")
    time.sleep(1)
    check(browser.run("return lookout.picture.scan.utime") == frozen, "pause holds the picture")
    stalled.close()
    second.quit()
    chain.stop()
    watch.send_signal(signal.SIGTERM)
    check(watch.wait(timeout=15) == 0, "the program stops with status 0 while a browser looks on")
    return browser, log


def watch_log(lookout, browser, log):
    watch = start_watch(lookout, [str(log)], LOG_PORT)
    browser.go(f"http://127.0.0.1:{LOG_PORT}/")
    frames = browser.wait("return lookout.state.frame === 0 && lookout.state.frames", "the log opens at its first frame")
    middle = frames // 2
    browser.run(f"const bar = document.getElementById('scrub'); bar.value = '{middle}'; bar.dispatchEvent(new Event('input'));")
    browser.wait(f"return lookout.state.frame === {middle} && lookout.picture.tracks.sequence > 0", "scrub shows the frame asked for")
    browser.wait("return lookout.trails.size > 0", "scrub brings the trails along")
    browser.click("#play")
    browser.wait(f"return lookout.state.frame > {middle + 2}", "play goes on from there")
    browser.click("#play")
    stopped = browser.run("return lookout.state.frame")
    time.sleep(1.5)
    check(abs(browser.run("return lookout.state.frame") - stopped) <= 1, "pause stops the log")
    watch.send_signal(signal.SIGTERM)
    check(watch.wait(timeout=15) == 0, "the program stops with status 0")


def median_latency(lookout, scenario, watched):
    """The tracker's p50 [ms] over one short run of the chain, alone or before two clients of which one is stalled."""
    watch = start_watch(lookout, [], WATCH_PORT) if watched else None
    clients = [stalled_client(), spawn(["cat"], stdin=streaming_client(), stdout=subprocess.DEVNULL)] if watched else []
    chain = Chain(lookout, scenario, seconds=4)
    chain.simulator.wait(timeout=60)
    latency = float(chain.stop().rsplit("p50 ", 1)[1].split()[0])
    if watched:
        clients[0].close()
        watch.send_signal(signal.SIGTERM)
        watch.wait(timeout=15)
        clients[1].wait(timeout=15)
    return latency


def compare_latency(lookout, scenario):
    """Fails where the ratio of latencies is above its bound by more than twice its standard error."""
    ratios = []
    for pair in range(LATENCY_PAIRS):
        order = (False, True) if pair % 2 == 0 else (True, False)
        latency = {watched: median_latency(lookout, scenario, watched) for watched in order}
        ratios.append(math.log(latency[True] / latency[False]))
    mean = statistics.mean(ratios)
    error = statistics.stdev(ratios) / math.sqrt(len(ratios))
    print(f"   latency ratio {math.exp(mean):.3f}, between {math.exp(mean - 2 * error):.3f} and {math.exp(mean + 2 * error):.3f}")
    check(mean - 2 * error <= math.log(LATENCY_RATIO), "a browser and a stalled one do not slow the tracker")


def main():
    inside_namespace()
    lookout, scenario = sys.argv[1], sys.argv[2]
    screenshot = pathlib.Path(sys.argv[4]) if "--screenshot" in sys.argv else None
    folder = pathlib.Path(tempfile.mkdtemp())
    spawn(["chromedriver", f"--port={DRIVER_PORT}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        for _ in range(50):
            try:
                Browser.request("GET", "/status")
                break
            except (OSError, urllib.error.URLError):
                time.sleep(0.2)
        browser, log = watch_live(lookout, scenario, folder, screenshot)
        watch_log(lookout, browser, log)
        browser.quit()
        compare_latency(lookout, scenario)
        print("passed")
    finally:
        end_everything()
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
