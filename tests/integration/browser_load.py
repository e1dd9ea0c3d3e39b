#!/usr/bin/python3
"""Heavy traffic for the browser view: 20 scans a second of 500 returns, and 100 tracks beside their true targets.

usage: browser_load.py URL. PYTHONPATH names the folder of our types. Publishes until it is ended, and prints once a
second how many scans it has sent and the time.
"""
import math
import random
import struct
import sys
import time

from lookout import (ground_truth_t, motion_elements_t, node_status_t, sonar_scan_t, target_truth_t, track_list_t, track_t,
                     vehicle_state_t)
from lookout_link import Link

RATE = 20
CYCLE_S = 5.0    # After which the scene repeats itself.
RADIUS = 0.5     # Of a target's circle [m].
BEAMS, RETURNS, TRACKS = 512, 500, 100
STEP = math.radians(120.0) / BEAMS
RANGE = 150.0
TRACK_SIGMA = 0.5  # Of a track about its target, north and east [m].


def targets_at(seconds):
    """Places and velocities of 100 targets inside the fan, each on a small circle, once around in CYCLE_S."""
    places, turn = [], 2.0 * math.pi / CYCLE_S
    for k in range(TRACKS):
        bearing, distance = math.radians(-50.0 + k % 10 * 11.0), 30.0 + k // 10 * 11.0
        phase = turn * seconds + k
        places.append((distance * math.cos(bearing) + RADIUS * math.cos(phase), distance * math.sin(bearing) + RADIUS * math.sin(phase),
                       -RADIUS * turn * math.sin(phase), RADIUS * turn * math.cos(phase)))
    return places


def truth_of(places, utime):
    truth = ground_truth_t()
    truth.utime, truth.num_targets = utime, len(places)
    for k, place in enumerate(places):
        target = target_truth_t()
        target.id, target.visible = k + 1, True
        target.north, target.east, target.north_velocity, target.east_velocity = place
        truth.targets.append(target)
    return truth


def tracks_of(places, utime, sequence, draw):
    tracks = track_list_t()
    tracks.utime, tracks.sequence, tracks.num_tracks = utime, sequence, len(places)
    for k, place in enumerate(places):
        track = track_t()
        track.id, track.status, track.existence, track.moving = k + 1, 1, 0.95, 1.0
        track.north, track.east = (draw.gauss(place[i], TRACK_SIGMA) for i in range(2))
        track.north_velocity, track.east_velocity = place[2:]
        for i in range(4):
            track.covariance[i][i] = TRACK_SIGMA**2
        track.last_detection_utime = utime
        tracks.tracks.append(track)
    return tracks


def scan_of(utime, sequence, draw):
    scan = sonar_scan_t()
    scan.utime, scan.sequence = utime, sequence
    scan.first_bearing, scan.bearing_step, scan.num_beams, scan.max_range = STEP * (0.5 - BEAMS / 2), STEP, BEAMS, RANGE
    scan.num_returns = RETURNS
    scan.bearing = [scan.first_bearing + STEP * beam for beam in sorted(draw.sample(range(BEAMS), RETURNS))]
    scan.range = [draw.uniform(1.0, RANGE) for _ in range(RETURNS)]
    scan.intensity = [1.0] * RETURNS
    return scan


class Encoded:
    """A message that was encoded before; it starts with fingerprint, utime and, where it has one, sequence."""

    def __init__(self, message):
        self.bytes, self.has_sequence = message.encode(), hasattr(message, "sequence")

    def at(self, utime, sequence):
        self.head = struct.pack(">qq", utime, sequence) if self.has_sequence else struct.pack(">q", utime)
        return self

    def encode(self):
        return self.bytes[:8] + self.head + self.bytes[8 + len(self.head):]


def frame_of(sequence, draw):
    """All messages of one scan."""
    places = targets_at(sequence / RATE)
    messages = {"VEHICLE_STATE": vehicle_state_t(), "SONAR_SCAN": scan_of(0, 0, draw), "GROUND_TRUTH": truth_of(places, 0),
                "MOTION_ELEMENTS": motion_elements_t(), "TRACKS": tracks_of(places, 0, 0, draw)}
    return {channel: Encoded(message) for channel, message in messages.items()}


def main():
    link, draw = Link(sys.argv[1]), random.Random(1)
    frames = [frame_of(sequence, draw) for sequence in range(int(CYCLE_S * RATE))]   # So that a busy machine keeps the rate.
    status = node_status_t()
    status.node_id, status.node, status.last_error = 1, "load", ""
    begin, sequence = time.monotonic(), 0
    while True:
        for channel, message in frames[sequence % len(frames)].items():
            link.publish(channel, message.at(int(sequence * 1e6 / RATE), sequence))
        if sequence % RATE == 0:
            link.publish("LOOKOUT_STATUS", status)
            print(sequence, time.monotonic(), flush=True)
        sequence += 1
        time.sleep(max(0.0, begin + sequence / RATE - time.monotonic()))


if __name__ == "__main__":
    main()
