#!/usr/bin/python3
"""Estimator, Tracker, Chain and track: every method by name, the tracks of the command line to the byte."""
import sys
import threading
import unittest

import lookout
import numpy as np
from support import SCENE, Case, recording


def posed(scans, **named):
    """A recording whose vehicle states are at the very times of its scans, and those poses."""
    poses = [(0.8e-6 * scan.utime, 0.2e-6 * scan.utime, 0.25) for scan in scans]
    north, east, heading = np.array(poses).T
    vehicle = {"utime": np.array([scan.utime for scan in scans]), "north": north, "east": east, "heading": heading}
    return lookout.Recording(scans, vehicle, **named), poses


class TrackTest(Case):
    def test_every_tracker_gives_the_tracks_of_lookout_run(self):
        scene = self.write("scene.yaml", SCENE)
        for tracker in lookout.tracker_names():
            theirs = self.folder / tracker
            self.command("run", scene, "--tracker", tracker, "--seed", 3, "--out", theirs)
            run = lookout.track(lookout.simulate(lookout.Scene(scene), seed=3), tracker=tracker, seed=3)
            lookout.write_tracks(self.folder / "tracks.csv", run.tracks)
            self.assert_same_bytes(self.folder / "tracks.csv", theirs / "tracks.csv")

    def test_a_dict_is_the_configuration_of_the_command_line(self):
        config = {"tracker": {"name": "csht", "coast_s": 3.0}, "estimator": {"name": "sht", "window_scans": 10},
                  "sensor": {"max_speed": 4.0}}
        words = ["--config", self.write("config.yaml", config), "--out", self.folder / "theirs"]
        self.command("run", self.write("scene.yaml", SCENE), *words)
        run = lookout.track(recording(1, config=config), config)
        lookout.write_tracks(self.folder / "tracks.csv", run.tracks)
        self.assert_same_bytes(self.folder / "tracks.csv", self.folder / "theirs" / "tracks.csv")

    def test_a_parameter_of_the_tracker_has_effect(self):
        known = recording()
        plain = lookout.track(known, tracker="gnn").tracks
        strict = lookout.track(known, {"tracker": {"name": "gnn", "gnn": {"life": {"confirm_hits": 8, "confirm_scans": 10}}}}).tracks
        self.assertFalse(np.array_equal(plain["status"], strict["status"]))

    def test_counts_what_came_in(self):
        run = lookout.track(recording(), tracker="gnn")
        self.assertEqual((run.counts["received"], run.counts["accepted"], len(run.times)), (24, 24, 24))
        self.assertEqual([result.utime for result in run.results], list(run.times))

    def test_a_lag_gives_all_scans_and_refuses_who_has_none(self):
        self.assertEqual(len(lookout.track(recording(), lag=2.0).times), 24)
        self.assertRegex(self.refusal(lookout.track, recording(), tracker="gnn", lag=2.0), "^--lag: tracker gnn")


class TrackerTest(Case):
    def test_scan_by_scan_is_the_chain(self):
        simulated = recording()
        known, poses = posed(simulated.scans, sensor=simulated.sensor)
        for name in ("joint", "csht"):
            tracker = lookout.Tracker(sensor=known.sensor, tracker=name)
            tables = [tracker.step(scan, pose).tracks for scan, pose in zip(known.scans, poses)]
            np.testing.assert_array_equal(np.concatenate(tables), lookout.track(known, tracker=name).tracks)

    def test_tells_its_methods_and_the_sonars_figures(self):
        tracker = lookout.Tracker()
        self.assertEqual((tracker.name, tracker.estimator), ("joint", "joint"))
        result = tracker.step(lookout.Scan(0, [0.1], [40.0]), (0.0, 0.0, 0.0))
        self.assertIn("miss_probability", result.sensor_estimate)
        self.assertEqual((result.tracks.dtype, result.elements.dtype), (lookout.TRACK_DTYPE, lookout.ELEMENT_DTYPE))

    def test_takes_the_geometry_of_the_scan(self):
        narrow = lookout.Sensor({"num_beams": 10, "max_range": 30.0})
        result = lookout.Tracker(tracker="gnn").step(lookout.Scan(0, [-0.75], [20.0], sensor=narrow), (0, 0, 0))
        self.assertEqual(len(result.tracks), 1)

    def test_refuses_a_scan_that_is_none(self):
        tracker = lookout.Tracker(tracker="gnn")
        scan = lookout.Scan(5, [0.1], [40.0])
        tracker.step(scan, (0.0, 0.0, 0.0))
        self.assertRegex(self.refusal(tracker.step, scan, (0.0, 0.0, 0.0)), "^scan: utime: got 5, expected more than 5")
        later = lookout.Scan(6, [0.1], [40.0])
        self.assertRegex(self.refusal(tracker.step, later, (0.0, float("nan"), 0.0)), "^pose: is not finite")
        damaged = lookout.Scan(2**60, [0.1], [40.0])
        self.assertRegex(self.refusal(tracker.step, damaged, (0.0, 0.0, 0.0)), "^scan: ")
        self.assertEqual(len(tracker.step(later, (0.0, 0.0, 0.0)).tracks), 1)  # None of that has harmed it.

    def test_refuses_as_the_command_line(self):
        scene, out = self.write("scene.yaml", SCENE), self.folder / "out"
        for config in ({"tracker": {"name": "nobody"}}, {"tracker": {"coast_s": -1}}, {"estimator": {"window": 5}},
                       {"tracker": {"name": "gnn", "joint": {"birth": {"begin_nats": 9}}}}):
            path = self.write("config.yaml", config)
            said = self.command("run", scene, "--config", path, "--out", out, status=2)
            self.assertEqual(self.refusal(lookout.Tracker, path), said)
            self.assertTrue(self.refusal(lookout.Tracker, config).startswith("config:"))
        said = self.command("run", scene, "--tracker", "gnn", "--estimator", "sht", "--out", out, status=2)
        self.assertEqual(self.refusal(lookout.Tracker, tracker="gnn", estimator="sht"), said)
        self.assertRegex(self.refusal(lookout.Tracker, estimator="h_pmht"), "h_pmht works on sonar images")

    def test_lets_other_threads_run(self):
        ready, seen = threading.Event(), []
        worker = threading.Thread(target=lambda: (ready.wait(), seen.append(True)))
        worker.start()
        known = recording()
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)  # [s] Nobody is asked for Python's lock: who has it must give it away.
        try:
            ready.set()
            for _ in range(200):
                if not seen:
                    lookout.track(known, tracker="gnn")
            self.assertTrue(seen)
        finally:
            sys.setswitchinterval(interval)
        worker.join()


class EstimatorTest(Case):
    def test_every_estimator_finds_the_targets(self):
        simulated = recording(unknown_sensor=True)
        known, poses = posed(simulated.scans)
        for name in lookout.estimator_names():
            estimator = lookout.Estimator(sensor=simulated.sensor, estimator=name)
            self.assertEqual(estimator.name, name)
            for scan, pose in zip(known.scans, poses):
                elements = estimator.update(scan, pose)
            self.assertEqual(elements.dtype, lookout.ELEMENT_DTYPE)
            self.assertGreaterEqual(len(elements), 1, name)

    def test_takes_its_window_from_the_configuration(self):
        self.assertEqual(lookout.Estimator({"estimator": {"name": "csht", "window_scans": 7}}).window_scans, 7)
        self.assertRegex(self.refusal(lookout.Estimator, estimator="gnn"), "^--estimator: got `gnn`, expected one of: joint")


class ChainTest(Case):
    def test_gives_as_it_comes_what_track_gives_whole(self):
        known = recording()
        chain = lookout.Chain(sensor=known.sensor, tracker="gnn")
        results = []
        for simulated in lookout.Simulator(lookout.Scene(SCENE), seed=1000):
            results += chain.add_states(simulated.states_before)
            results += chain.add_scan(simulated.scan)
            results += chain.add_states(simulated.states_after)
        results += chain.finish()
        tracks = np.concatenate([result.tracks for result in results])
        np.testing.assert_array_equal(tracks, lookout.track(known, tracker="gnn").tracks)
        self.assertEqual(chain.counts["accepted"], 24)
        self.assertEqual(chain.notes, [])

    def test_tells_what_it_misses_and_loses_no_result(self):
        chain = lookout.Chain(tracker="gnn")
        times = [0, 500_000]
        chain.add_states({"utime": times, "north": [0.0, 0.0], "east": [0.0, 0.0], "heading": [0.0, 0.0]})
        results = chain.add_scan(lookout.Scan(0, [0.1], [40.0], sequence=0))
        with self.assertRaisesRegex(UserWarning, "lost before sequence 2"):  # A warning is an error here.
            results += chain.add_scan(lookout.Scan(500_000, [0.1], [40.0], sequence=2))
        results += chain.finish()
        self.assertEqual([result.utime for result in results], times)
        self.assertEqual(chain.counts["lost"], 1)
        self.assertEqual(len(chain.notes), 1)


if __name__ == "__main__":
    unittest.main()
