#!/usr/bin/python3
"""An imaging sonar's driver: pings of 256 uneven beams and 703 ranges, 360 kB each."""
import math
import time

from lookout import sonar_image_t, vehicle_state_t
from lookout_link import Link

link = Link()
for ping in range(20):
    state = vehicle_state_t()
    state.utime = time.time_ns() // 1000
    link.publish("VEHICLE_STATE", state)

    image = sonar_image_t()
    image.utime = state.utime
    image.sequence = ping
    image.num_beams, image.num_bins = 256, 703
    image.bearing = [math.asin((k - 127.5) / 255) for k in range(256)]  # Radians, even in the sine: strictly monotonic.
    image.first_range, image.range_step = 0.05, 0.1  # Metres, of the centre of bin 0 and between bins.
    image.intensity_scale = 1.0  # Sensor units of one step of the integers.
    image.intensity = [[20 + (7 * beam + 3 * k + ping) % 5 for k in range(703)] for beam in range(256)]
    link.publish("SONAR_IMAGE", image)
    time.sleep(0.2)
