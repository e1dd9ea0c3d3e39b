#!/usr/bin/python3
"""Sensor, Scan and Image."""
import math
import pathlib
import unittest

import lookout
import numpy as np
from support import SOURCE, Case


class SensorTest(Case):
    def test_defaults_are_those_of_the_paper(self):
        sensor = lookout.Sensor()  # [Yan2018] Table 1.
        self.assertEqual((sensor.num_beams, sensor.max_range, sensor.range_sigma), (90, 150.0, 3.0))
        self.assertAlmostEqual(sensor.first_bearing, math.radians(-44.5))
        self.assertAlmostEqual(sensor.bearing_sigma, math.radians(1.0) / math.sqrt(12.0))
        self.assertIsNone(sensor.miss_probability)

    def test_takes_the_keys_of_sonar_yaml(self):
        values = {"num_beams": np.int64(10), "bearing_step_deg": 3, "mount_x": 1.5, "mount_heading_deg": 90.0}
        sensor = lookout.Sensor(values)
        self.assertEqual(sensor.num_beams, 10)
        self.assertAlmostEqual(sensor.bearing_step, math.radians(3.0))
        np.testing.assert_allclose(sensor.mount, [1.5, 0.0, math.pi / 2])
        self.assertEqual(lookout.Sensor(self.write("sonar.yaml", sensor.yaml())).yaml(), sensor.yaml())

    def test_refuses_in_one_line(self):
        self.assertRegex(self.refusal(lookout.Sensor, {"beams": 3}), r"^sensor:1:\d+: .*beams")
        self.assertRegex(self.refusal(lookout.Sensor, {"range_sigma": -1.0}), "^sensor:1:.*range_sigma")
        self.assertRegex(self.refusal(lookout.Sensor, {"range_sigma": object()}), "^sensor: holds")
        self.assertRegex(self.refusal(lookout.Sensor, 3), "^sensor: expected a dict")
        self.assertRegex(self.refusal(lookout.Sensor, pathlib.Path("absent.yaml")), "^absent.yaml: ")


class ScanTest(Case):
    def test_holds_the_arrays_and_the_sonars_geometry(self):
        scan = lookout.Scan(7, [0.1, -0.2], np.array([40, 50]), sensor=lookout.Sensor({"num_beams": 20}), sequence=3)
        self.assertEqual((scan.utime, scan.sequence, scan.num_beams, len(scan)), (7, 3, 20, 2))
        np.testing.assert_array_equal(scan.bearings, [0.1, -0.2])
        np.testing.assert_array_equal(scan.ranges, [40.0, 50.0])
        np.testing.assert_array_equal(scan.intensities, [1.0, 1.0])

    def test_arrays_look_into_the_scan_and_outlive_its_name(self):
        ranges = lookout.Scan(0, np.zeros(1000), np.arange(1000.0)).ranges
        self.assertEqual(ranges.sum(), 499500.0)  # The sum of 0 to 999.
        with self.assertRaises(ValueError):
            ranges[0] = 1.0

    def test_a_scan_may_be_silent(self):
        self.assertEqual(lookout.Scan(0, [], []).ranges.shape, (0,))

    def test_refuses_arrays_that_do_not_belong_together(self):
        self.assertRegex(self.refusal(lookout.Scan, 0, [0.1], [1.0, 2.0]), "^ranges: expected")
        self.assertRegex(self.refusal(lookout.Scan, 0, [0.1], [1.0], [1.0, 2.0]), "^intensities: expected")
        self.assertRegex(self.refusal(lookout.Scan, 0, [[0.1]], [1.0]), "^bearings: expected")


class ImageTest(Case):
    def test_has_a_row_a_beam(self):
        image = next(lookout.Simulator(lookout.Scene(SOURCE / "tools/scenarios/sonar_image.yaml"))).image
        self.assertEqual(image.intensities.shape, (len(image.bearings), len(image.ranges)))
        self.assertGreater(image.intensities.max(), 0.0)
        self.assertTrue((np.diff(image.ranges) > 0.0).all())


if __name__ == "__main__":
    unittest.main()
