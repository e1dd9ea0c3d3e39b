#!/usr/bin/python3
"""A sonar's driver: its target list as messages. PYTHONPATH names the folder of our types, share/lookout/python."""
import time

from lookout import sonar_scan_t, vehicle_state_t
from lookout_link import Link

link = Link()  # At LCM_DEFAULT_URL, else LCM's own address.
for ping in range(40):
    state = vehicle_state_t()
    state.utime = time.time_ns() // 1000
    state.north = 0.1 * ping  # Metres; heading in radians clockwise from north.
    link.publish("VEHICLE_STATE", state)

    scan = sonar_scan_t()
    scan.utime = state.utime  # When the ping was sent; the pose at that very time serves it.
    scan.sequence = ping  # One more each ping: gaps are counted as losses.
    scan.first_bearing, scan.bearing_step, scan.num_beams = -0.7766715, 0.0174533, 90  # Radians, starboard positive.
    scan.max_range = 150.0
    scan.bearing, scan.range, scan.intensity = [0.1, -0.5], [40.0, 90.0], [1.0, 1.0]  # One entry an echo.
    scan.num_returns = 2  # Must be the size of all three.
    link.publish("SONAR_SCAN", scan)
    time.sleep(0.1)
