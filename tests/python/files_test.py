#!/usr/bin/python3
"""Recordings, tables and LCM logs: what is written is read back, and by the command line too."""
import unittest

import lookout
import numpy as np
from support import SCENE, Case, recording


class RecordingTest(Case):
    def test_reads_back_what_was_written(self):
        known = recording()
        lookout.write_recording(self.folder / "dive", known)
        back = lookout.read_recording(self.folder / "dive")
        np.testing.assert_array_equal(back.times, known.times)
        np.testing.assert_array_equal(back.vehicle["north"], known.vehicle["north"])
        np.testing.assert_array_equal(back.truth, known.truth)
        self.assertEqual(back.sensor.yaml(), known.sensor.yaml())
        for one, other in zip(back.scans, known.scans):
            np.testing.assert_array_equal(one.ranges, other.ranges)

    def test_is_made_of_arrays(self):
        scans = [lookout.Scan(500_000 * k, [0.1], [40.0 + k]) for k in range(3)]
        vehicle = {"utime": [0, 1_000_000], "north": [0.0, 1.0], "east": [0.0, 0.0], "heading": [0.0, 0.0]}
        made = lookout.Recording(scans, vehicle, {"utime": [0], "north": [40.0], "east": [4.0]})
        self.assertEqual((len(made), made.is_fixed, made.sensor), (3, False, None))
        self.assertEqual(made.truth["id"], [1])
        self.assertEqual(len(lookout.track(made, tracker="gnn").times), 3)

    def test_without_a_vehicle_the_sonar_stands_at_the_origin(self):
        made = lookout.Recording([lookout.Scan(0, [0.1], [40.0])])
        lookout.write_recording(self.folder / "fixed", made)
        self.assertFalse((self.folder / "fixed" / "vehicle.csv").exists())
        with self.assertWarnsRegex(UserWarning, "no vehicle.csv"):
            self.assertTrue(lookout.read_recording(self.folder / "fixed").is_fixed)

    def test_refuses_what_goes_back_in_time(self):
        scans = [lookout.Scan(utime, [0.1], [40.0]) for utime in (5, 4)]
        self.assertRegex(self.refusal(lookout.Recording, scans), "^scans: goes back in time")
        lacking = {"utime": [0], "north": [0.0], "east": [0.0]}
        self.assertEqual(self.refusal(lookout.Recording, [], lacking), "vehicle: heading: is not a field of the table")

    def test_refuses_as_the_command_line(self):
        lookout.write_recording(self.folder / "dive", recording())
        self.write("dive/scans.csv", "time_s,bearing_rad,range_m\n0,0.1,far\n")
        said = self.command("replay", self.folder / "dive", "--out", self.folder / "out", status=2)
        self.assertEqual(self.refusal(lookout.read_recording, self.folder / "dive"), said)
        self.assertRegex(self.refusal(lookout.read_recording, self.folder / "absent"), "absent: is not a directory")
        self.assertRegex(self.refusal(lookout.read_recording, 7), "^path: expected")

    def test_does_not_remove_sonar_images(self):
        (self.folder / "images.csv").write_text("time_s\n")
        self.assertRegex(self.refusal(lookout.write_recording, self.folder, recording()), "holds sonar images")


class TablesTest(Case):
    def test_tracks_and_truth_read_back(self):
        known = recording()
        tracks = lookout.track(known, tracker="gnn").tracks
        lookout.write_tracks(self.folder / "tracks.csv", tracks)
        lookout.write_truth(self.folder / "truth.csv", known.truth)
        back = lookout.read_tracks(self.folder / "tracks.csv")
        for field in ("utime", "id", "status", "north", "east_velocity", "existence", "moving"):
            np.testing.assert_array_equal(back[field], tracks[field])
        np.testing.assert_array_equal(lookout.read_truth(self.folder / "truth.csv"), known.truth)

    def test_refuses_with_file_line_and_column(self):
        path = self.write("tracks.csv", "time_s,north_m,east_m\n0,1,2\n1,x,2\n")
        self.assertRegex(self.refusal(lookout.read_tracks, path), r"tracks.csv:3: north_m")
        self.assertRegex(self.refusal(lookout.write_tracks, self.folder, recording().truth), "expected a plain file")


class LogTest(Case):
    def test_is_replayed_by_the_command_line(self):
        known = recording()
        run = lookout.track(known, tracker="gnn", seed=1)
        log = self.folder / "dive.lcmlog"
        lookout.write_log(log, known, run.tracks, channel_prefix="AUV1_")
        config = self.write("config.yaml", "sensor: {range_sigma: 1.0}\n")
        self.command("replay", log, "--channel-prefix", "AUV1_", "--tracker", "gnn", "--config", config, "--out", self.folder / "out")
        lookout.write_tracks(self.folder / "tracks.csv", run.tracks)
        self.assert_same_bytes(self.folder / "tracks.csv", self.folder / "out" / "logged_tracks.csv")

        back = lookout.read_log(log, "AUV1_", sensor=known.sensor)
        self.assertEqual(back.channels["AUV1_SONAR_SCAN"], 24)
        for field in ("id", "north", "covariance", "first_utime", "last_detection_utime"):
            np.testing.assert_array_equal(back.tracks[field], run.tracks[field])
        np.testing.assert_array_equal(lookout.track(back.recording, tracker="gnn").tracks, run.tracks)

    def test_of_the_simulator_gives_the_simulated_recording(self):
        log = self.folder / "sim.lcmlog"
        scene = self.write("scene.yaml", SCENE)
        self.command("sim", scene, "--speed", "max", "--seed", 1000, "--lcm-url", f"file://{log}?mode=w")
        back, known = lookout.read_log([log]).recording, recording()
        np.testing.assert_array_equal(back.times, known.times)
        np.testing.assert_array_equal(back.truth, known.truth)
        np.testing.assert_array_equal(back.scans[-1].ranges, known.scans[-1].ranges)

    def test_refuses_what_is_no_log(self):
        path = self.write("dive.lcmlog", "time_s\n")
        said = self.command("replay", path, "--out", self.folder / "out", status=2)
        self.assertEqual(self.refusal(lookout.read_log, path), said)
        tracks = {"utime": [1], "north": [0.0], "east": [0.0]}
        self.assertRegex(self.refusal(lookout.write_log, path, recording(), tracks), "^tracks: those at")
        self.assertEqual(path.read_text(), "time_s\n")  # Nothing half written took its place.


if __name__ == "__main__":
    unittest.main()
