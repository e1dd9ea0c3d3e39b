#!/usr/bin/python3
"""Scene, Simulator and simulate: the same scans as the command line's, to the byte."""
import unittest

import lookout
import numpy as np
from support import SCENE, SOURCE, Case, recording


class SimulateTest(Case):
    def test_gives_the_recording_of_lookout_run(self):
        scene = self.write("scene.yaml", SCENE)
        self.command("run", scene, "--tracker", "gnn", "--seed", 5, "--out", self.folder / "theirs")
        lookout.write_recording(self.folder / "ours", lookout.simulate(lookout.Scene(scene), seed=5))
        for name in ("scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml"):
            self.assert_same_bytes(self.folder / "ours" / name, self.folder / "theirs" / name)

    def test_the_seed_and_the_run_fix_every_draw(self):
        ranges = [recording(seed, run=run).scans[0].ranges for seed, run in ((1, 0), (1, 0), (1, 1), (2, 0))]
        np.testing.assert_array_equal(ranges[0], ranges[1])
        self.assertFalse(np.array_equal(ranges[0], ranges[2]))
        self.assertFalse(np.array_equal(ranges[0], ranges[3]))

    def test_tells_what_is_known_of_the_sonar(self):
        self.assertEqual(recording().sensor.miss_probability, 0.1)
        self.assertIsNone(recording(unknown_sensor=True).sensor.miss_probability)
        told = lookout.Scene(SCENE).sensor(config={"sensor": {"range_sigma": 2.0}}, unknown=True)
        self.assertEqual((told.range_sigma, told.num_beams), (2.0, 60))

    def test_truth_is_where_the_targets_go(self):
        truth = recording().truth
        first = truth[truth["id"] == 1]
        self.assertEqual(truth.dtype, lookout.TRUTH_DTYPE)
        np.testing.assert_allclose(first["north"], 60.0 - 0.6e-6 * first["utime"])
        self.assertEqual(truth[truth["id"] == 2]["utime"].min(), 2_000_000)  # It appears at 2 s.


class SceneTest(Case):
    def test_names_its_sonars_as_the_folders_of_lookout_run(self):
        self.assertEqual(lookout.Scene(SCENE).sonars, [""])
        several = lookout.Scene(SOURCE / "tools/scenarios/sea_two_sonars.yaml")
        self.assertEqual(len(several.sonars), 2)
        self.assertNotEqual(*[lookout.simulate(several, sonar=i).scans[0].sensor_id for i in range(2)])

    def test_refuses_as_the_command_line(self):
        broken = self.write("broken.yaml", dict(SCENE, sonar={"range_sigma": -1}))
        said = self.command("run", broken, "--out", self.folder / "out", status=2)
        self.assertEqual(self.refusal(lookout.Scene, broken), said)
        self.assertRegex(self.refusal(lookout.Scene, dict(SCENE, speed=1)), "^scene:1:.*speed")
        self.assertRegex(self.refusal(lookout.simulate, lookout.Scene(SCENE), sonar=1), "^sonar: got 1, expected 0 to 0")
        self.assertRegex(self.refusal(lookout.Simulator, lookout.Scene(SCENE), vehicle=2), "^vehicle: got 2")


class SimulatorTest(Case):
    def test_gives_scan_by_scan_what_simulate_gives_whole(self):
        whole = recording(7).scans
        single = list(lookout.Simulator(lookout.Scene(SCENE), seed=7))
        self.assertEqual(len(single), 24)  # 12 s, two scans a second.
        for one, other in zip(single, whole):
            np.testing.assert_array_equal(one.scan.ranges, other.ranges)

    def test_states_stand_on_either_side_of_the_scan(self):
        first = next(lookout.Simulator(lookout.Scene(SCENE)))
        states = np.concatenate([first.states_before, first.states_after])
        self.assertEqual(states.dtype, lookout.STATE_DTYPE)
        self.assertTrue((np.diff(states["utime"]) > 0).all())
        self.assertIsNone(first.image)
        self.assertEqual(first.sonar_pose[:2], [0.0, 0.0])
        self.assertEqual(set(first.truth["utime"]), {first.scan.utime})


if __name__ == "__main__":
    unittest.main()
