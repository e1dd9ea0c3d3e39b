#!/usr/bin/python3
"""The browser view in a real browser: heavy traffic, a live chain at 20 scans a second, then the log of it.

usage: browser_test.py LOOKOUT SCENARIO PYTHON_FOLDER [--screenshot FILE.png | --latency ERROR]
  --latency  measure alone what watching costs the tracker, in short turns, until the standard errors of the ratios are at
             most ERROR; 0.007 takes a quarter of an hour on a busy machine and needs no chromium

Runs publishers, tracker, logger and `lookout watch` over UDP multicast in a network namespace of its own, and a headless
chromium that a test drives through chromedriver. Status 77 where this machine cannot run it; `tools/setup --with-browser`
installs what is needed.
"""
import math
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

import browser_latency
from browser_driver import Browser, check, end_everything, fail, skip, spawn, start_driver

GROUP, PORT = "239.255.76.67", 7667
URL = f"udpm://{GROUP}:{PORT}?ttl=0"
WATCH_PORT, LOG_PORT = 8080, 8081
SPEED = 10              # Times real time: 20 scans a second of a sonar with a period of 0.5 s.
LATENCY_SPEED = 100     # 200 scans a second while latencies are compared.
LISTEN_S = 20
LARGEST_ERROR_M = 3.0   # Of a confirmed track where there is a target.
FEWEST_LOOKS = 5        # At all targets in that time, on a machine that does other things.
LEAST_HEARD = 0.5       # Of the messages, in the page.
LARGEST_LOAD = 0.15     # Of a core, by the program's own CPU time.
LATENCY_RATIO = 1.05
LATENCY_ERROR = 0.02    # Standard error of the ratio that a test takes the time for.
BEYOND_CHANCE = 3.5     # Standard errors above the bound that no machine's noise explains: once in some thousand tests.
NORMAL_95 = 1.96        # Standard errors about a mean that hold 95 %.
MOST_PAIRS_ALONE = 4000
MOST_SECONDS = 3600     # Of the chain whose latencies are compared.
PATCH = (-35.0, -20.0, 60.0, 90.0)  # Of dense clutter in the scenario: bearings [deg] and ranges [m].


def inside_namespace():
    if os.environ.get("LOOKOUT_BROWSER_TEST") == "inside":
        return
    for tool in ("lcm-logger",) if "--latency" in sys.argv else ("chromium", "chromedriver", "lcm-logger"):
        if not shutil.which(tool):
            skip(f"{tool} is not installed (tools/setup --with-browser)")
    if subprocess.run(["unshare", "-rn", "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        skip("no private network namespace (unshare -rn) here")
    os.environ["LOOKOUT_BROWSER_TEST"] = "inside"
    setup = 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@"'
    os.execvp("unshare", ["unshare", "-rn", "sh", "-c", setup, sys.executable, *sys.argv])


class Chain:
    """Simulator, tracker and logger of their own for a while; what the tracker decides goes to a file."""

    def __init__(self, lookout, scenario, folder, words, speed=SPEED, seconds=600):
        self.started, self.log, self.decisions = [], folder / "log", folder / "decisions.txt"
        self.tracker = None
        self.start(["lcm-logger", "--quiet", "--force", f"--lcm-url={URL}", str(self.log)])
        with open(self.decisions, "wb") as decisions:
            self.tracker = self.start([lookout, "track", *words, "--lcm-url", URL], stderr=decisions)
        self.start([lookout, "sim", scenario, "--wait-for", "1", "--speed", str(speed), "--lcm-url", URL, "--duration", str(seconds)],
                   stderr=None)

    def start(self, words, stderr=subprocess.DEVNULL):
        self.started.append(spawn(words, stdout=subprocess.DEVNULL, stderr=stderr))
        return self.started[-1]

    def stop(self):
        for process in reversed(self.started):
            process.send_signal(signal.SIGINT)
        for process in self.started:
            process.wait(timeout=20)


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


def stop_watch(process, when):
    process.send_signal(signal.SIGTERM)
    check(process.wait(timeout=15) == 0, f"the program stops with status 0 {when}")


def stalled_client():
    """A browser that asks for the stream and never reads."""
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.connect(("127.0.0.1", WATCH_PORT))
    client.sendall(b"GET /events HTTP/1.1\r\nHost: x\r\n\r\n")
    return client


# The page has the newest of each topic: tracks and truth may be a scan apart, 0.5 s, in which a target moves 0.5 m.
ERRORS = """
  const tracks = lookout.picture.tracks, truth = lookout.picture.truth;
  if (!tracks || !truth || Math.abs(tracks.utime - truth.utime) > 0.5e6) return null;
  return truth.targets.filter((t) => t.visible).map((t) => Math.min(...tracks.tracks
    .filter((k) => k.status === 'confirmed').map((k) => Math.hypot(k.north - t.north, k.east - t.east))));
"""


def check_tracks(browser, fewest):
    """Looks at the page for LISTEN_S: a confirmed track where each visible target is."""
    errors, end = [], time.monotonic() + LISTEN_S
    while time.monotonic() < end:
        errors += [math.inf if error is None else error for error in browser.run(ERRORS) or []]
        time.sleep(0.1)
    near = sum(error < LARGEST_ERROR_M for error in errors)
    print(f"   {len(errors)} targets seen, {near} of them with a track within {LARGEST_ERROR_M} m")
    check(len(errors) >= fewest and near > 0.9 * len(errors), "tracks stand where the targets are")


def scans_a_second(said):
    """By the lines of browser_load.py: scans sent, time [s]."""
    (first, begin), *_, (last, end) = (map(float, line.split()) for line in said.splitlines())
    return (last - first) / (end - begin)


def watch_load(lookout, python, folder):
    """500 returns and 100 tracks 20 times a second before two browsers and a stalled one."""
    watch = start_watch(lookout, [], WATCH_PORT)
    load = spawn([sys.executable, str(pathlib.Path(__file__).with_name("browser_load.py")), URL],
                 env={**os.environ, "PYTHONPATH": python}, stdout=subprocess.PIPE, text=True)
    browser, second = Browser(folder / "a"), Browser(folder / "b")
    stalled = stalled_client()
    for each in (browser, second):
        each.go(f"http://127.0.0.1:{WATCH_PORT}/")
    browser.wait("return lookout.picture.scan && lookout.picture.scan.returns.length === 1000 && lookout.picture.tracks.tracks.length === 100",
                 "the page loads and hears 500 returns and 100 tracks")
    begin, used, events = time.monotonic(), cpu_seconds(watch.pid), browser.run("return lookout.state.events")
    check_tracks(browser, 100 * FEWEST_LOOKS)
    seconds = time.monotonic() - begin
    share = (cpu_seconds(watch.pid) - used) / seconds
    rate = (browser.run("return lookout.state.events") - events) / seconds
    load.terminate()
    sent = scans_a_second(load.communicate(timeout=20)[0])
    print(f"   {sent:.1f} scans/s sent, {rate:.0f} events/s in the page; {share:.3f} of a core")
    check(sent > 0.9 * 2 * SPEED, "20 scans a second are sent")
    # Four topics a scan; a browser on a busy machine may miss what came in between, but not most of it.
    check(rate > LEAST_HEARD * 4 * sent, "scans, states, tracks and truth reach the page")
    check(share < LARGEST_LOAD, f"the program takes less than {LARGEST_LOAD} of a core with two browsers and a stalled one")
    check(second.run("return lookout.state.events") > LEAST_HEARD * 4 * sent * LISTEN_S, "a second browser sees it as well")
    stalled.close()
    second.quit()
    stop_watch(watch, "while a browser looks on")
    return browser


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


def check_map(browser):
    """Two fingers zoom; bow up and back."""
    box = browser.run("const box = document.getElementById('map').getBoundingClientRect(); return [box.left + box.width / 2, box.top + box.height / 2];")
    before = browser.run("return lookout.map.scale")
    browser.pinch(*box, 100, 200)
    zoomed = browser.run("return lookout.map.scale") / before
    check(abs(zoomed - 2.0) < 0.2, f"two fingers twice as far apart show it twice as large: {zoomed:.2f}")
    browser.pinch(*box, 200, 100)
    for up in (True, False):
        browser.click("#orient")
        check(browser.run("return lookout.map.bowUp") == up, "bow up" if up else "and north up")


DECISIONS = "return Array.from(document.getElementById('decisions').children).map((line) => line.textContent);"


def check_decisions(browser):
    """What was decided about the chosen track stands in the page, the beginning last."""
    browser.wait("return document.getElementById('decisions').children.length >= 2", "the page shows what the tracker decided")
    chosen, lines = browser.run("return lookout.state.chosen"), browser.run(DECISIONS)
    check(all(f" s track {chosen}: " in line for line in lines), f"of the chosen track alone: {lines[-1]}")
    check(": begin," in lines[-1] and any(": confirm," in line for line in lines), "how it began and why it was confirmed")


PATCH_COLOUR = """
  const map = lookout.map, clutter = lookout.picture.clutter, at = map.context;
  if (!clutter || !map.clutterShown(lookout.picture)) return null;
  map.scans = [];
  map.draw({clutter, tracks: {utime: clutter.utime, tracks: []}}, new Map(), null);
  const r = window.devicePixelRatio || 1, orange = (bearing, range) => {
    const [x, y] = map.toScreen(range * Math.cos(bearing), range * Math.sin(bearing));
    const [red, , blue] = at.getImageData(Math.round(x * r), Math.round(y * r), 1, 1).data;
    return red > 1.5 * blue;
  };
  const share = (first, last, near, far) => {
    let sum = 0;
    for (let i = 0; i < 10; i++) for (let j = 0; j < 10; j++)
      sum += orange((first + (i + 0.5) * (last - first) / 10) * Math.PI / 180, near + (j + 0.5) * (far - near) / 10);
    return sum / 100;
  };
"""


def check_clutter(browser):
    """The clutter map that the tracker learns is drawn where the scenario's patch of dense clutter is."""
    first, last, near, far = PATCH
    browser.wait(PATCH_COLOUR + f"return share({first}, {last}, {near}, {far}) > 0.6;", "the learnt clutter map is drawn where clutter is dense",
                 60)
    elsewhere = browser.run(PATCH_COLOUR + f"return share({-last}, {-first}, {near}, {far});")
    check(elsewhere is not None and elsewhere < 0.4, f"and not on the other side: {elsewhere}")


def watch_live(lookout, scenario, browser, folder, screenshot):
    chain = Chain(lookout, scenario, folder, ["--explain", "--publish-clutter", "2"])
    watch = start_watch(lookout, [], WATCH_PORT)
    browser.go(f"http://127.0.0.1:{WATCH_PORT}/")
    browser.wait("return lookout.picture.scan && lookout.picture.tracks", "the page hears a live chain")
    check_map(browser)
    choose_a_track(browser)
    check_decisions(browser)
    check_clutter(browser)
    check_tracks(browser, 4 * FEWEST_LOOKS)
    if screenshot:
        browser.click("#tentative")
        browser.wait("const list = lookout.picture.tracks; return list && list.utime > 100e6;", "a picture worth keeping", 60)
        choose_a_track(browser)
        browser.click("#pause")
        browser.screenshot(screenshot)
        browser.click("#pause")
    browser.click("#pause")
    frozen = browser.run("return lookout.picture.scan.utime")
    time.sleep(1)
    check(browser.run("return lookout.picture.scan.utime") == frozen, "pause holds the picture")
    chain.stop()
    stop_watch(watch, "while a browser looks on")
    return chain


def watch_log(lookout, browser, chain):
    watch = start_watch(lookout, [str(chain.log), "--decisions", str(chain.decisions)], LOG_PORT)
    browser.go(f"http://127.0.0.1:{LOG_PORT}/")
    frames = browser.wait("return lookout.state.frame === 0 && lookout.state.frames", "the log opens at its first frame")
    middle = frames // 2
    scrub_to(browser, middle)
    browser.wait(f"return lookout.state.frame === {middle} && lookout.picture.tracks.sequence > 0", "scrub shows the frame asked for")
    browser.wait("return lookout.trails.size > 0", "scrub brings the trails along")
    browser.click("#play")
    browser.wait(f"return lookout.state.frame > {middle + 2}", "play goes on from there")
    browser.click("#play")
    stopped = browser.run("return lookout.state.frame")
    time.sleep(1.5)
    check(abs(browser.run("return lookout.state.frame") - stopped) <= 1, "pause stops the log")
    choose_a_track(browser)
    check_decisions(browser)
    check_clutter(browser)
    count = len(browser.run(DECISIONS))
    scrub_to(browser, 0)
    browser.wait(f"return lookout.state.frame === 0 && document.getElementById('decisions').children.length < {count}",
                 "at an earlier frame what was decided later is not shown")
    stop_watch(watch, "after a log")


def scrub_to(browser, frame):
    browser.run(f"const bar = document.getElementById('scrub'); bar.value = '{frame}'; bar.dispatchEvent(new Event('input'));")


class ReadingClient:
    """A browser that takes all that it gets."""

    def __init__(self):
        self.client = stalled_client()
        self.thread = threading.Thread(target=self.read)
        self.thread.start()

    def read(self):
        while self.client.recv(65536):
            pass

    def close(self):
        self.client.shutdown(socket.SHUT_RDWR)
        self.thread.join()
        self.client.close()


def quiet_scene(scenario, folder):
    """The scenario without its sea and with few false alarms, in which a tracker has the same to do in every scan, and longer."""
    scene, text = folder / "quiet.yaml", pathlib.Path(scenario).read_text()
    quiet = text.replace("false_alarm_probability: 0.05", "false_alarm_probability: 0.01").replace("duration: 40000.0", "duration: 400000.0")
    scene.write_text(quiet[: quiet.index("sea:")] + quiet[quiet.index("targets:"):])
    return str(scene)


def check_ratio(what, ratio, error):
    """Fails where the ratio is above its bound beyond chance. How near to one it is, --latency says: docs/watching.md."""
    low, high = (math.exp(ratio + side * NORMAL_95 * error) for side in (-1.0, 1.0))
    print(f"   {what}: ratio {math.exp(ratio):.3f}, 95 % of {low:.3f} to {high:.3f}", flush=True)
    check(ratio - BEYOND_CHANCE * error <= math.log(LATENCY_RATIO), f"two clients, one stalled, cost the tracker no {what}")


def compare_latency(lookout, scenario, folder, largest_error=LATENCY_ERROR, most_pairs=browser_latency.MOST_PAIRS):
    """What a scan costs the tracker before two clients, one of them stalled, over what it costs before none, in one run."""
    chain = Chain(lookout, quiet_scene(scenario, folder), folder, ["--tracker", "gnn"], LATENCY_SPEED, seconds=MOST_SECONDS)
    watch = start_watch(lookout, [], WATCH_PORT)
    latency, cpu, pairs = browser_latency.compare(browser_latency.Listener(GROUP, PORT), chain.tracker.pid,
                                                  lambda: [ReadingClient(), stalled_client()], largest_error, most_pairs)
    check(pairs >= browser_latency.FEWEST_PAIRS, f"scans were tracked while latencies were compared, {pairs} pairs of blocks")
    check_ratio("latency", *latency)
    check_ratio("CPU time", *cpu)
    chain.stop()
    stop_watch(watch, "after a stalled browser")


def watch_in_browser(lookout, scenario, python, folder):
    screenshot = pathlib.Path(sys.argv[5]) if "--screenshot" in sys.argv else None
    start_driver()
    browser = watch_load(lookout, python, folder)
    chain = watch_live(lookout, scenario, browser, folder, screenshot)
    watch_log(lookout, browser, chain)
    browser.quit()


def main():
    inside_namespace()
    lookout, scenario, python = sys.argv[1:4]
    folder = pathlib.Path(tempfile.mkdtemp())
    try:
        if "--latency" in sys.argv:
            compare_latency(lookout, scenario, folder, float(sys.argv[5]), MOST_PAIRS_ALONE)
        else:
            watch_in_browser(lookout, scenario, python, folder)
            compare_latency(lookout, scenario, folder)
        print("passed")
    finally:
        end_everything()
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
