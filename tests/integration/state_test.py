#!/usr/bin/python3
"""A tracker that is killed (SIGKILL) at five moments of a scene and started again by its state.

The targets in view keep their identities, are reported again with the first scan, and no identity comes twice.
usage: state_test.py LOOKOUT SCENARIO. Status 77 where this machine cannot run it.
"""
import atexit
import csv
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

URL = "udpm://239.255.76.67:7667?ttl=0"
SPEED = 2.0  # the state is two seconds old at most, so that four of scenario are missing
PERIOD = 0.5  # s between scans
KILLS = (18.0, 36.0, 50.0, 66.0, 82.0)  # s of scenario
NEAR = 10.0  # m: a track after a restart this near to where one before must be is on the same target


def enter_namespace():
    """Starts this test again where loopback and multicast are its own."""
    inside = "ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec \"$0\" \"$@\" inside"
    if subprocess.run(["unshare", "-rn", "true"], capture_output=True).returncode != 0:
        print("SKIPPED: no private network namespace (unshare -rn) here")
        sys.exit(77)
    os.execvp("unshare", ["unshare", "-rn", "sh", "-c", inside, *sys.argv])


def start_tracker(lookout, folder, number):
    said = open(folder / f"track{number}.txt", "w")
    tracker = subprocess.Popen([lookout, "track", "--lcm-url", URL, "--state", folder / "state"], stderr=said)
    atexit.register(tracker.kill)
    return tracker


def run_scene(lookout, scenario, folder):
    """The scene with its kills; the log of all that was sent."""
    log = folder / "run.lcmlog"
    logger = subprocess.Popen(["lcm-logger", "--quiet", f"--lcm-url={URL}", log])
    tracker = start_tracker(lookout, folder, 0)
    atexit.register(logger.kill)
    simulator = subprocess.Popen([lookout, "sim", scenario, "--lcm-url", URL, "--speed", str(SPEED), "--wait-for", "1"],
                                 stderr=subprocess.DEVNULL)
    while not (folder / "state").exists():
        time.sleep(0.02)  # The first state: the scene has begun.
    begin = time.monotonic()
    for number, moment in enumerate(KILLS, 1):
        time.sleep(max(0.0, begin + moment / SPEED - time.monotonic()))
        tracker.kill()
        tracker.wait()
        tracker = start_tracker(lookout, folder, number)
    simulator.wait()
    time.sleep(1)
    tracker.terminate()
    assert tracker.wait() == 0, "the last tracker did not stop with status 0"
    logger.send_signal(signal.SIGINT)
    logger.wait()
    return log


def confirmed_lists(path):
    """Time -> confirmed tracks by identity, from the TRACKS that went over the link."""
    lists = {}
    for row in csv.DictReader(open(path)):
        tracks = lists.setdefault(float(row["time_s"]), {})
        if row["status"] == "confirmed":
            tracks[int(row["id"])] = [float(row[key]) for key in
                                      ("north_m", "east_m", "north_velocity_mps", "east_velocity_mps")]
    return lists


def successor(track, seconds, candidates):
    """The identity of the track that lies where this one must be by now."""
    north, east = track[0] + seconds * track[2], track[1] + seconds * track[3]
    distances = {i: ((c[0] - north) ** 2 + (c[1] - east) ** 2) ** 0.5 for i, c in candidates.items()}
    nearest = min(distances, key=distances.get, default=None)
    return nearest if nearest is not None and distances[nearest] < NEAR else None


def main():
    lookout, scenario = sys.argv[1:3]
    if sys.argv[-1] != "inside":
        enter_namespace()
    if not shutil.which("lcm-logger"):
        print("SKIPPED: lcm-logger is not installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log = run_scene(lookout, scenario, folder)
        subprocess.run([lookout, "replay", log, "--out", folder / "replay"], check=True, stderr=subprocess.DEVNULL)
        lists = confirmed_lists(folder / "replay" / "logged_tracks.csv")
        said = "".join((folder / f"track{n}.txt").read_text() for n in range(len(KILLS) + 1))
    times = sorted(lists)
    gaps = [(a, b) for a, b in zip(times, times[1:]) if b - a > 1.5 * PERIOD]
    same = other = absent = 0
    for before, after in gaps:
        for identity, track in lists[before].items():
            found = successor(track, after - before, lists[after])
            same += found == identity
            other += found not in (None, identity)
            absent += found is None
        print(f"gap {before} to {after} s: {sorted(lists[before])} -> {sorted(lists[after])}")
    print(f"{len(gaps)} gaps; identities kept {same}, changed {other}, not reported with the first scan {absent}")
    assert said.count("goes on where") == len(KILLS), said
    assert gaps, "no gap in the reports: nothing was killed"
    # A track that begins or ends within the age of the state is another one afterwards.
    assert other <= 1, "identities changed"
    assert same >= 3 * (other + absent), "too few tracks were reported again with the first scan"


if __name__ == "__main__":
    main()
