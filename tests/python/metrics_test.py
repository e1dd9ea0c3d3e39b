#!/usr/bin/python3
"""The metrics: hand cases, and the values of `lookout ospa` to the last digit."""
import csv
import json
import math
import unittest

import lookout
import numpy as np
from support import Case, recording


def table(rows):
    """Anyone's table: (utime, id, north, east) a row."""
    utime, number, north, east = np.array(rows, dtype=float).T
    return {"utime": utime.astype(int), "id": number.astype(int), "north": north, "east": east}


class PointsTest(Case):
    def test_ospa_by_hand(self):
        # A pair at 3 m and a missing track: sqrt((9 + 20^2) / 2).
        result = lookout.ospa([[0, 0], [50, 0]], [[3, 0]])
        self.assertAlmostEqual(result.total, math.sqrt(409 / 2))
        self.assertAlmostEqual(result.localization, math.sqrt(9 / 2))
        self.assertAlmostEqual(result.cardinality, math.sqrt(400 / 2))
        self.assertEqual((result.num_truth, result.num_tracks), (2, 1))
        self.assertEqual(lookout.ospa([[0, 0]], [[3, 0]], order=math.inf).total, 3.0)

    def test_gospa_by_hand(self):
        # A pair at 3 m; each miss costs cutoff^2 / 2.
        result = lookout.gospa([[0, 0], [50, 0]], [[3, 0]])
        self.assertAlmostEqual(result.total, math.sqrt(9 + 200))
        self.assertAlmostEqual(result.missed, math.sqrt(200))
        self.assertEqual((result.localization, result.false_tracks, result.num_missed, result.num_false), (3.0, 0.0, 1, 0))

    def test_sets_may_be_empty(self):
        self.assertEqual(lookout.ospa([], []).total, 0.0)
        self.assertEqual(lookout.ospa([], np.zeros((3, 2)), cutoff=5.0).total, 5.0)

    def test_refuses_what_is_no_set_of_points(self):
        self.assertRegex(self.refusal(lookout.ospa, [1.0, 2.0], []), r"^truth: expected an array of shape \(n, 2\)")
        self.assertRegex(self.refusal(lookout.gospa, [], [[1.0, math.nan]]), "^estimate: row 0 is not finite")
        self.assertIn("cutoff", self.refusal(lookout.ospa, [], [], cutoff=-1.0))
        self.assertIn("order", self.refusal(lookout.gospa, [], [], order=0.5))


class ScoreTest(Case):
    def setUp(self):
        super().setUp()
        self.known = recording()
        self.tracks = lookout.track(self.known, tracker="gnn").tracks
        lookout.write_recording(self.folder, self.known)
        lookout.write_tracks(self.folder / "tracks.csv", self.tracks)

    def theirs(self, *words):
        return self.command("ospa", self.folder / "truth.csv", self.folder / "tracks.csv", "--json", *words)

    def test_every_metric_is_that_of_the_command_line(self):
        for metric in ("ospa", "gospa", "ospa2", "tgospa"):
            over_time = self.folder / "over_time.csv"
            theirs = json.loads(self.theirs("--metric", metric, "--over-time", over_time))
            score = lookout.score(self.known.truth, self.tracks, self.known.times, metric, over_time=True)
            self.assertEqual(theirs, score.parts | {"times": len(self.known.times)})
            self.assertEqual(score.total, score.parts["total"])
            with open(over_time, newline="") as file:
                rows = list(csv.DictReader(file))
            for name, values in score.over_time.items():
                read = [float(row["time_s" if name == "utime" else name]) for row in rows]
                np.testing.assert_allclose(values * (1e-6 if name == "utime" else 1.0), read, rtol=0, atol=1e-12)

    def test_options_are_those_of_the_command_line(self):
        theirs = json.loads(self.theirs("--metric", "ospa2", "--window", 3, "--cutoff", 10, "--order", 1, "--truth", "schedule"))
        score = lookout.score(self.known.truth, self.tracks, self.known.times, "ospa2", cutoff=10.0, order=1.0,
                              truth_kind="schedule", window=3.0)
        self.assertEqual(theirs["total"], score.total)
        theirs = json.loads(self.theirs("--metric", "tgospa", "--switch-penalty", 5))
        score = lookout.score(self.known.truth, self.tracks, self.known.times, "tgospa", switch_penalty=5.0)
        self.assertEqual(theirs["total"], score.total)

    def test_refuses_as_the_command_line(self):
        for flag, named in (("--metric nobody", {"metric": "nobody"}), ("--cutoff 0", {"cutoff": 0.0}),
                            ("--window 3", {"window": 3.0}), ("--truth all", {"truth_kind": "all"}),
                            ("--time-tolerance -1", {"time_tolerance": -1.0})):
            said = self.command("ospa", self.folder / "truth.csv", self.folder / "tracks.csv", *flag.split(), status=2)
            self.assertEqual(self.refusal(lookout.score, self.known.truth, self.tracks, **named), said)

    def test_takes_anyones_table(self):
        truth = table([(0, 1, 0, 0), (1_000_000, 1, 1, 0)])
        tracks = table([(0, 9, 3, 0), (1_000_000, 9, 1, 4)])
        score = lookout.score(truth, tracks)
        self.assertAlmostEqual(score.total, 3.5)  # The mean of 3 m and 4 m.
        np.testing.assert_allclose(score.over_time["localization"], [3.0, 4.0])
        matched = lookout.score(truth, table([(400, 9, 3, 0), (1_000_400, 9, 1, 4)]), time_tolerance=0.01)
        self.assertAlmostEqual(matched.total, 3.5)

    def test_refuses_a_table_that_is_none(self):
        good = table([(0, 1, 0, 0)])
        for change, line in (({"utime": [0.5]}, "truth: utime: expected whole numbers"),
                             ({"north": [math.nan]}, "truth: north: got a number that is not finite"),
                             ({"north": [1.0, 2.0]}, "truth: north: 2 values, expected 1"),
                             ({"north": ["a"]}, "truth: north: expected numbers")):
            self.assertEqual(self.refusal(lookout.score, good | change, good), line)
        self.assertEqual(self.refusal(lookout.score, good, np.zeros((3, 2))), "tracks: utime: is not a field of the table")
        twice = table([(0, 1, 0, 0), (0, 1, 5, 0)])
        self.assertEqual(self.refusal(lookout.score, twice, good), "truth: id: row 1 repeats 1 at its time")
        back = table([(5, 1, 0, 0), (4, 1, 5, 0)])
        self.assertEqual(self.refusal(lookout.score, good, back), "tracks: utime: row 1 goes back in time")


class TrackQualityTest(Case):
    def test_by_hand(self):
        # Track 7 follows the target in 12 scans, then track 8 in 12: one switch, and all followed.
        times = np.arange(24) * 1_000_000
        truth = table([(t, 1, 0, 0) for t in times])
        tracks = table([(t, 7 if i < 12 else 8, 1, 0) for i, t in enumerate(times)])
        quality = lookout.track_quality(truth, tracks)
        self.assertEqual((quality.identity_switches, quality.identities, quality.followed_share), (1, 2.0, 1.0))
        self.assertEqual((quality.targets[0].id, quality.targets[0].median_error), (1, 1.0))
        self.assertEqual(lookout.track_quality(truth, tracks, gate=0.5).followed_share, 0.0)
        self.assertIn("gate", self.refusal(lookout.track_quality, truth, tracks, gate=-1.0))


if __name__ == "__main__":
    unittest.main()
