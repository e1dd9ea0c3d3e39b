#!/usr/bin/python3
"""Plug-ins: their methods go by name as in the command line, with the same tracks; what is no plug-in is refused by its line."""
import os
import pathlib
import unittest

import lookout
from support import SCENE, Case, recording

TOY = pathlib.Path(os.environ["LOOKOUT_TOY_PLUGIN"])


class PluginTest(Case):
    @classmethod
    def setUpClass(cls):
        cls.before = lookout.tracker_names(), lookout.estimator_names()
        lookout.load_plugin(TOY)

    def test_its_names_join_the_others(self):
        self.assertEqual(lookout.tracker_names(), [*self.before[0], "toy_tracker"])
        self.assertEqual(lookout.estimator_names(), [*self.before[1], "toy"])

    def test_gives_the_tracks_of_the_command_line(self):
        scene = self.write("scene.yaml", SCENE)
        births = {"tracker": {"name": "gnn", "initiator": "toy"}, "initiator": {"toy_speed": 0.5}}
        for config in ({"tracker": {"name": "toy_tracker"}}, births):
            path = self.write("config.yaml", config)
            self.command("run", scene, "--plugin", TOY, "--config", path, "--out", self.folder / "theirs")
            run = lookout.track(recording(1), path)
            self.assertGreater(len(run.tracks), 0, config)
            lookout.write_tracks(self.folder / "tracks.csv", run.tracks)
            self.assert_same_bytes(self.folder / "tracks.csv", self.folder / "theirs" / "tracks.csv")

    def test_goes_scan_by_scan(self):
        scan = lookout.Scan(0, [0.1], [40.0])
        tracks = lookout.Tracker(tracker="toy_tracker").step(scan, (0.0, 0.0, 0.0)).tracks
        self.assertEqual([(row["north"], row["east"]) for row in tracks], [(30.0, 40.0)])  # where the toy has its target
        self.assertEqual(len(lookout.Estimator(estimator="toy").update(scan, (0.0, 0.0, 0.0))), 1)

    def test_a_bad_configuration_of_it_is_refused(self):
        config = {"tracker": {"name": "gnn", "initiator": "toy"}, "initiator": {"toy_speed": -1}}
        self.assertIn("toy_speed", self.refusal(lookout.Tracker, config))

    def test_refuses_as_the_command_line(self):
        scene, text = self.write("scene.yaml", SCENE), self.write("text.so", "no library")
        for path in (self.folder / "absent.so", text):
            said = self.command("run", scene, "--plugin", path, "--out", self.folder / "none", status=2)
            self.assertEqual(self.refusal(lookout.load_plugin, path), said)
        self.assertRegex(self.refusal(lookout.load_plugin, TOY), "the estimator `toy` exists already")


if __name__ == "__main__":
    unittest.main()
