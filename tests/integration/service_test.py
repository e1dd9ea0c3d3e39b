#!/usr/bin/python3
"""`lookout track` as systemd runs it (Type=notify, WatchdogSec), with a stand-in that speaks the notify protocol.

It starts before there is a network and waits; says how it is; a process that hangs feeds the watchdog no more and is
started again; two under one name tell of one another; SIGTERM ends it with status 0.
usage: service_test.py LOOKOUT. Status 77 where this machine cannot run it.
"""
import atexit
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

PATIENCE = 60.0  # s that anything may take on a busy machine
WATCHDOG = 4.0  # s without a word after which the stand-in bites


class Manager:
    """Starts the service and hears what it says, as systemd does."""

    def __init__(self, lookout, folder, name):
        self.path = folder / f"{name}.socket"
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(str(self.path))
        self.said = open(folder / f"{name}.txt", "w+")
        self.lookout = lookout
        self.start()

    def start(self):
        environment = dict(os.environ, NOTIFY_SOCKET=str(self.path))
        self.process = subprocess.Popen([self.lookout, "track", "--lcm-url", "udpm://239.255.76.67:7667?ttl=0"],
                                        env=environment, stderr=self.said)

    def hear(self, timeout):
        self.socket.settimeout(timeout)
        try:
            return self.socket.recv(4096).decode()
        except socket.timeout:
            return None

    def wait_for(self, word):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            heard = self.hear(PATIENCE)
            if heard and heard.startswith(word):
                return heard
        raise AssertionError(f"never heard {word}")

    def wait_for_line(self, text):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if text in pathlib.Path(self.said.name).read_text():
                return
            self.hear(0.1)
        raise AssertionError(f"never said: {text}")

    def watch(self):
        """Kills the process when it has been silent for too long. Returns when that has happened."""
        while self.hear(WATCHDOG) is not None:
            pass
        self.process.kill()
        self.process.wait()


def enter_namespace():
    if subprocess.run(["unshare", "-rn", "true"], capture_output=True).returncode != 0:
        print("SKIPPED: no private network namespace (unshare -rn) here")
        sys.exit(77)
    os.execvp("unshare", ["unshare", "-rn", *sys.argv, "inside"])


def main():
    if sys.argv[-1] != "inside":
        enter_namespace()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        first = Manager(sys.argv[1], folder, "first")
        atexit.register(lambda: first.process.kill())
        first.wait_for("READY=1")
        first.wait_for_line("trying again until it can")
        first.wait_for("WATCHDOG=1")  # It waits, and says so.
        subprocess.run("ip link set lo up && ip route add 224.0.0.0/4 dev lo", shell=True, check=True)
        assert "no scan heard yet" in first.wait_for("STATUS=no data")
        first.process.send_signal(signal.SIGSTOP)
        first.watch()
        first.start()
        first.wait_for("READY=1")
        first.wait_for("WATCHDOG=1")
        second = Manager(sys.argv[1], folder, "second")
        atexit.register(second.process.kill)
        for manager in (first, second):
            manager.wait_for_line("another tracker publishes on LOOKOUT_STATUS as node 1")
        for manager in (first, second):
            manager.process.terminate()
            assert manager.process.wait(PATIENCE) == 0, "SIGTERM is status 0"
    print("passed")


if __name__ == "__main__":
    main()
