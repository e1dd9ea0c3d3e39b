#!/usr/bin/python3
"""A tracker that is killed (SIGKILL) at five moments of a scene and started again by its state.

The targets in view keep their identities and are reported again within two scans. Each scan waits for the tracks of
the one before, so that what is tested is the same on a machine of any speed; how long each new process took is printed.
usage: state_test.py LOOKOUT SCENARIO PYTHON_FOLDER. Status 77 where this machine cannot run it.
"""
import atexit
import os
import pathlib
import select
import socket
import struct
import subprocess
import sys
import tempfile
import time

GROUP, PORT = "239.255.76.67", 7667
URL = f"udpm://{GROUP}:{PORT}?ttl=0"
KILLS = (28, 52, 76, 100, 124)  # Scans after which the state is waited for.
UNKEPT = 3  # Scans after it, before the kill: the state is two seconds old at most, which are four.
LOST = 2  # Scans that nobody hears.
WATCHED = 10  # Scans after the last restart.
NEAR = 10.0  # m: a track after a restart this near to where one before must be is on the same target.
PATIENCE = 60.0  # s: a tracker that says nothing for so long hangs.
CONFIRMED = 1  # track_t.status


def enter_namespace():
    """Starts this test again where loopback and multicast are its own."""
    inside = "ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec \"$0\" \"$@\" inside"
    if subprocess.run(["unshare", "-rn", "true"], capture_output=True).returncode != 0:
        print("SKIPPED: no private network namespace (unshare -rn) here")
        sys.exit(77)
    os.execvp("unshare", ["unshare", "-rn", "sh", "-c", inside, *sys.argv])


class Ear:
    """Hears the small messages of the link."""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._socket.bind((GROUP, PORT))
        membership = struct.pack("4s4s", socket.inet_aton(GROUP), socket.inet_aton("127.0.0.1"))
        self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)

    def forget(self):
        """What has come so far is heard no more."""
        while select.select([self._socket], [], [], 0)[0]:
            self._socket.recv(65536)

    def wait_for(self, channel, fits=lambda data: True):
        """The data of the next message on `channel` that fits."""
        end = time.monotonic() + PATIENCE
        while select.select([self._socket], [], [], max(0.0, end - time.monotonic()))[0]:
            name, _, data = self._socket.recv(65536)[8:].partition(b"\0")
            if name == channel.encode() and fits(data):
                return data
        sys.exit(f"FAILED: nothing came on {channel} for {PATIENCE:.0f} s")


class Scene:
    """The scans of a scene as lookout sim publishes them, each with the vehicle states up to the next."""

    def __init__(self, lookout, scenario, folder):
        from lookout import sonar_scan_t
        from lookout_link import read_log
        log = folder / "scene.lcmlog"
        subprocess.run([lookout, "sim", scenario, "--lcm-url", f"file://{log}?mode=w", "--speed", "max"], check=True,
                       stderr=subprocess.DEVNULL)
        self.scans, messages = [], []
        for channel, data in read_log(log):
            if channel == "SONAR_SCAN":
                messages = messages if not self.scans else []
                self.scans.append((sonar_scan_t.decode(data).utime, messages))
            if channel in ("SONAR_SCAN", "VEHICLE_STATE"):
                messages.append((channel, data))


class Encoded:
    """A message whose bytes are known."""

    def __init__(self, data):
        self._data = data

    def encode(self):
        return self._data


class Watch:
    """Sends the scans of a scene to a tracker, which may be killed and started again."""

    def __init__(self, lookout, scene, folder):
        from lookout_link import Link
        self._lookout, self._scans, self._folder = lookout, iter(scene.scans), folder
        self._link, self._ear, self._said = Link(URL), Ear(), open(folder / "said.txt", "w")
        self.state = folder / "state"

    def start(self):
        """Starts a tracker, and waits until it listens: its status is sent once it does."""
        self._ear.forget()
        begin = time.monotonic()
        self.tracker = subprocess.Popen([self._lookout, "track", "--lcm-url", URL, "--state", self.state],
                                        stderr=self._said)
        atexit.register(self.tracker.kill)
        self._ear.wait_for("LOOKOUT_STATUS")
        return time.monotonic() - begin

    def kill(self):
        self.tracker.kill()
        self.tracker.wait()

    def send(self, without=()):
        """The next scan and the vehicle states up to the one after it; its time."""
        utime, messages = next(self._scans)
        for channel, data in messages:
            if channel not in without:
                self._link.publish(channel, Encoded(data))
        return utime

    def lose(self, count):
        """So many scans are not heard. The vehicle states beside them are."""
        for _ in range(count):
            self.send(without=("SONAR_SCAN",))

    def track(self, count):
        """Sends so many scans, one after the other; time [s] and confirmed tracks of the last."""
        from lookout import track_list_t
        for _ in range(count):
            utime = self.send()
            data = self._ear.wait_for("TRACKS", lambda data: track_list_t.decode(data).utime == utime)
        tracks = track_list_t.decode(data).tracks
        return utime * 1e-6, {track.id: track for track in tracks if track.status == CONFIRMED}

    def wait_for_state(self):
        """Until the state has been written anew."""
        before = self.state.stat().st_mtime_ns
        while self.state.stat().st_mtime_ns == before:
            time.sleep(0.02)

    def said(self):
        return (self._folder / "said.txt").read_text()


def successor(track, seconds, candidates):
    """The identity of the track that lies where this one must be by now."""
    north, east = track.north + seconds * track.north_velocity, track.east + seconds * track.east_velocity
    distances = {i: ((c.north - north) ** 2 + (c.east - east) ** 2) ** 0.5 for i, c in candidates.items()}
    nearest = min(distances, key=distances.get, default=None)
    return nearest if nearest is not None and distances[nearest] < NEAR else None


def main():
    lookout, scenario, python = sys.argv[1:4]
    if sys.argv[-1] != "inside":
        enter_namespace()
    sys.path.insert(0, python)
    same = other = absent = sent = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        watch = Watch(lookout, Scene(lookout, scenario, folder), folder)
        watch.start()
        for moment in KILLS:
            watch.track(moment - sent)
            watch.wait_for_state()
            begin, before = watch.track(UNKEPT)
            watch.kill()
            took = watch.start()
            watch.lose(LOST)
            end, after = watch.track(2)
            sent = moment + UNKEPT + LOST + 2
            for identity, track in before.items():
                found = successor(track, end - begin, after)
                same += found == identity
                other += found not in (None, identity)
                absent += found is None
            print(f"{begin} to {end} s: {sorted(before)} -> {sorted(after)}; the new process spoke after {took:.2f} s")
        watch.track(WATCHED)
        watch.tracker.terminate()
        assert watch.tracker.wait() == 0, "the last tracker did not stop with status 0"
        assert watch.said().count("goes on where") == len(KILLS), watch.said()
    print(f"identities kept {same}, changed {other}, not reported within two scans {absent}")
    assert other == 0, "identities changed"
    assert same >= 3 * absent and same >= 3 * len(KILLS), "too few tracks were reported again within two scans"


if __name__ == "__main__":
    main()
