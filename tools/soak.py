#!/usr/bin/python3
"""Hours of a vehicle's life through the real chain, to see that memory and latency stay flat and no count goes back.

usage: tools/soak.py [--hours 1] [--minutes 600] [--period 0.5] [--program build/lookout] [--scenario tools/scenarios/soak.yaml] [--out soak.csv]
       [-- TRACK_OPTIONS]

Runs `lookout sim --speed max` and `lookout track` over UDP multicast in a network namespace of their own, samples the
tracker's memory and reads its LOOKOUT_STATUS once a second, and prints a table of quarter hours of scenario time (of
hours, for more than two). Every further hour has the targets of the scene's first anew. Where
the machine needs more than --minutes it ends there and says how far it came. --period is the time between scans. Exits with 1 where a count went
back, scans were not accepted, or memory grew from the second hour to the last by more than a tenth.
"""
import argparse
import csv
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time

URL = "udpm://239.255.76.67:7667?ttl=0"
LOG_EVENT = struct.Struct(">IqqII")  # mark, number, time, lengths of channel and data
LOG_MARK = 0xEDA1DA01
STATUS = struct.Struct(">qqi5q2d")  # fingerprint, utime, node_id, accepted to send_errors, latencies p50, p99
MINUTE, QUARTER, HOUR = 60.0, 900.0, 3600.0  # s
ANSWER_WAIT = "60"  # s for which the next scan waits for a tracker whose processor is given to others
MOST_GROWTH = 0.1  # of resident memory, from the second hour's end to the last's
MOVING = re.compile(r"  - \{.*\}")


def enter_namespace():
    """Runs this script again in a network namespace of its own, with a multicast route."""
    if os.environ.get("LOOKOUT_SOAK") == "inside":
        return
    environment = dict(os.environ, LOOKOUT_SOAK="inside")
    setup = 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@"'
    os.execvpe("unshare", ["unshare", "-rn", "sh", "-c", setup, *sys.argv], environment)


def number(line, key, otherwise=None):
    found = re.search(rf"\b{key}: (-?[\d.]+)", line)
    return float(found.group(1)) if found else otherwise


def an_hour_later(line, hour):
    """A target that comes and goes, `hour` hours later: its position is that of time 0, from where it goes straight."""
    for place in ("north", "east"):
        begin = number(line, place) - number(line, f"{place}_velocity") * HOUR * hour
        line = re.sub(rf"\b{place}: -?[\d.]+", f"{place}: {begin:.1f}", line)
    for time_key in ("appear", "disappear"):
        line = re.sub(rf"\b{time_key}: [\d.]+", f"{time_key}: {number(line, time_key) + HOUR * hour:.1f}", line)
    return re.sub(r"\bid: (\d+)", lambda found: f"id: {int(found.group(1)) + 1000 * hour}", line)


def lengthened(scenario, hours, period):
    """The scene over so many hours, a scan every `period` seconds, as text."""
    text = pathlib.Path(scenario).read_text()
    passing = [line for line in text.splitlines() if MOVING.match(line) and number(line, "disappear") is not None]
    further = [an_hour_later(line, hour) for hour in range(1, hours) for line in passing]
    text = re.sub(r"scan_period: [\d.]+", f"scan_period: {period}", text)
    return re.sub(r"duration: [\d.]+", f"duration: {HOUR * hours}", text) + "".join(line + "\n" for line in further)


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
            _, utime, node, *counts, p50, p99 = STATUS.unpack_from(data, begin)
            if node > 0:
                yield wall * 1e-6, utime * 1e-6, counts, p50, p99
        at = begin + size


def run(arguments, folder):
    """Runs the three processes; returns (wall time, resident kB) samples and what the tracker said at its end."""
    log, scene = folder / "log", folder / "scene.yaml"
    scene.write_text(lengthened(arguments.scenario, arguments.hours, arguments.period))
    logger = subprocess.Popen(["lcm-logger", "--quiet", f"--lcm-url={URL}", "--channel=LOOKOUT_STATUS", str(log)])
    tracker = subprocess.Popen(
        [arguments.program, "track", "--lcm-url", URL, *arguments.track_options], stderr=subprocess.PIPE, text=True
    )
    simulator = subprocess.Popen(
        [arguments.program, "sim", scene, "--speed", "max", "--answer-wait", ANSWER_WAIT, "--wait-for", "1", "--lcm-url", URL]
    )
    samples, end = [], time.monotonic() + MINUTE * arguments.minutes
    while simulator.poll() is None:
        if time.monotonic() > end:
            simulator.terminate()
        samples.append((time.time(), resident_kb(tracker.pid)))
        time.sleep(1.0)
    time.sleep(1.5)
    tracker.send_signal(signal.SIGTERM)
    said = tracker.communicate()[1].strip().splitlines()[-1]
    logger.send_signal(signal.SIGINT)
    logger.wait()
    return samples, said, list(statuses(log))


def table(rows, hours):
    """Prints a row a quarter hour, or an hour of many; returns them as lists of samples."""
    step, name = (QUARTER, "quarter hour") if hours <= 2 else (HOUR, "hour")
    print(f"{name:12s}   scans   resident kB (first to last)   latency p50 ms   p99 ms (of the newest 1000 scans)")
    parts = [[row for row in rows if int(row[0] // step) == part] for part in sorted({int(row[0] // step) for row in rows})]
    for part in parts:
        first, last = part[0], part[-1]
        print(f"{int(last[0] // step) + 1:12d} {last[1][0]:7d} {first[2]:17d} to {last[2]:7d} {last[3]:20.3f} {last[4]:8.3f}")
    return parts


def complaints(rows, parts, period):
    """What is wrong with a run, a line each."""
    done = int(rows[-1][0] / period)
    for before, after in zip(rows, rows[1:]):
        if any(new < old for old, new in zip(before[1], after[1])):
            yield f"a count went back from {before[1]} to {after[1]} at {after[0]:.0f} s"
    accepted, *others = rows[-1][1]
    if any(others):
        yield f"rejected, dropped, shed, not sent: {others}, expected none"
    if accepted < done:
        yield f"{accepted} scans accepted, expected {done}"
    if len(parts) > 2 and parts[-1][-1][2] > (1.0 + MOST_GROWTH) * parts[1][-1][2]:
        yield f"memory grew from {parts[1][-1][2]} to {parts[-1][-1][2]} kB"


def main():
    enter_namespace()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hours", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=600.0)
    parser.add_argument("--period", type=float, default=0.5)
    parser.add_argument("--program", default="build/lookout")
    parser.add_argument("--scenario", default="tools/scenarios/soak.yaml")
    parser.add_argument("--out", default="soak.csv")
    parser.add_argument("track_options", nargs="*")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        samples, said, heard = run(arguments, pathlib.Path(folder))
    rows = []
    for wall, scenario, counts, p50, p99 in heard:
        nearest = min(samples, key=lambda sample: abs(sample[0] - wall))
        rows.append((scenario, counts, nearest[1], p50, p99))
    with open(arguments.out, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time_s", "scans", "resident_kb", "latency_ms_p50", "latency_ms_p99"])
        writer.writerows([time_s, counts[0], *others] for time_s, counts, *others in rows)
    print(said)
    wrong = list(complaints(rows, table(rows, arguments.hours), arguments.period))
    print(f"soak: {rows[-1][0] / HOUR:.2f} of {arguments.hours} hours done")
    print("\n".join(wrong) or "soak: flat, every scan accepted")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
