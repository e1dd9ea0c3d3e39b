#!/usr/bin/python3
"""An hour of a vehicle's life through the real chain, to see that memory and latency stay flat.

usage: tools/soak.py [--program build/lookout] [--scenario tools/scenarios/soak.yaml] [--out soak.csv] [-- TRACK_OPTIONS]

Runs `lookout sim --speed max` and `lookout track` over UDP multicast in a network namespace of their own, samples the
tracker's memory and reads its LOOKOUT_STATUS once a second, and prints a table of quarter hours of scenario time.
"""
import argparse
import csv
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time

URL = "udpm://239.255.76.67:7667?ttl=0"
LOG_EVENT = struct.Struct(">IqqII")  # mark, number, time, lengths of channel and data
LOG_MARK = 0xEDA1DA01
STATUS = struct.Struct(">qqiqqqdd")  # fingerprint, utime, node_id, accepted, rejected, dropped, latencies
QUARTER = 900.0  # s


def enter_namespace():
    """Runs this script again in a network namespace of its own, with a multicast route."""
    if os.environ.get("LOOKOUT_SOAK") == "inside":
        return
    environment = dict(os.environ, LOOKOUT_SOAK="inside")
    setup = 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@"'
    os.execvpe("unshare", ["unshare", "-rn", "sh", "-c", setup, *sys.argv], environment)


def resident_kb(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    raise RuntimeError("no VmRSS")


def statuses(log):
    """(wall time, scenario time, accepted, p50, p99) of each status of the tracker in an LCM log."""
    data, at = log.read_bytes(), 0
    while at + LOG_EVENT.size <= len(data):
        mark, _, wall, channel_size, size = LOG_EVENT.unpack_from(data, at)
        if mark != LOG_MARK:
            raise RuntimeError(f"{log}: not an LCM log at byte {at}")
        begin = at + LOG_EVENT.size + channel_size
        if data[at + LOG_EVENT.size : begin] == b"LOOKOUT_STATUS" and begin + STATUS.size <= len(data):
            _, utime, node, accepted, _, _, p50, p99 = STATUS.unpack_from(data, begin)
            if node > 0:
                yield wall * 1e-6, utime * 1e-6, accepted, p50, p99
        at = begin + size


def run(arguments, folder):
    """Runs the three processes; returns (wall time, resident kB) samples and what the tracker said at its end."""
    log = folder / "log"
    logger = subprocess.Popen(["lcm-logger", "--quiet", f"--lcm-url={URL}", "--channel=LOOKOUT_STATUS", str(log)])
    tracker = subprocess.Popen(
        [arguments.program, "track", "--lcm-url", URL, *arguments.track_options], stderr=subprocess.PIPE, text=True
    )
    simulator = subprocess.Popen(
        [arguments.program, "sim", arguments.scenario, "--speed", "max", "--wait-for", "1", "--lcm-url", URL]
    )
    samples = []
    while simulator.poll() is None:
        samples.append((time.time(), resident_kb(tracker.pid)))
        time.sleep(1.0)
    time.sleep(1.5)
    tracker.send_signal(signal.SIGTERM)
    said = tracker.communicate()[1].strip().splitlines()[-1]
    logger.send_signal(signal.SIGINT)
    logger.wait()
    return samples, said, list(statuses(log))


def main():
    enter_namespace()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/lookout")
    parser.add_argument("--scenario", default="tools/scenarios/soak.yaml")
    parser.add_argument("--out", default="soak.csv")
    parser.add_argument("track_options", nargs="*")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        samples, said, heard = run(arguments, pathlib.Path(folder))
    rows = []
    for wall, scenario, accepted, p50, p99 in heard:
        nearest = min(samples, key=lambda sample: abs(sample[0] - wall))
        rows.append((scenario, accepted, nearest[1], p50, p99))
    with open(arguments.out, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time_s", "scans", "resident_kb", "latency_ms_p50", "latency_ms_p99"])
        writer.writerows(rows)
    print(said)
    print("quarter hour   scans   resident kB (first to last)   latency p50 ms   p99 ms (of the newest 1000 scans)")
    for quarter in sorted({int(row[0] // QUARTER) for row in rows}):
        part = [row for row in rows if int(row[0] // QUARTER) == quarter]
        print(f"{quarter + 1:12d} {part[-1][1]:7d} {part[0][2]:17d} to {part[-1][2]:7d} {part[-1][3]:20.3f} {part[-1][4]:8.3f}")


if __name__ == "__main__":
    main()
