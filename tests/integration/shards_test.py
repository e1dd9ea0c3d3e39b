#!/usr/bin/python3
"""Threads 1 and 2, shards 1, 4 and 12 of an experiment: equal results, and refusals of shards that do not belong.

Usage: shards_test.py LOOKOUT
"""
import json
import pathlib
import subprocess
import sys
import tempfile

EXPERIMENT = ["experiment", "agfht-table2", "--only", "method=fpht", "--only", "method=modified_ht", "--runs", "3", "--seed", "1000"]
MEASURED = "time_ms"  # Processor time, the one metric that is no result of the seed.


def lookout(program, *words, expected=0):
    done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    assert done.returncode == expected, f"{words}: {done.returncode}: {done.stderr}"
    return done.stderr


def results_of(directory):
    """Both files without the measured time, as text: equal to the byte or not."""
    results = json.loads((directory / "results.json").read_text())
    for cell in results["cells"]:
        cell["metrics"].pop(MEASURED)
    lines = (directory / "results.csv").read_text().splitlines()
    return json.dumps(results), [line for line in lines if f",{MEASURED}," not in line]


def run_shards(program, folder, count, *further):
    directories = []
    for k in range(1, count + 1):
        directories.append(str(folder / f"shard{k}of{count}"))
        lookout(program, *EXPERIMENT, *further, "--shard", f"{k}/{count}", "--out", directories[-1])
    return directories


def refused(program, text, *words):
    message = lookout(program, "merge", *words, expected=2)
    assert text in message and message.count("\n") == 1, message


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        lookout(program, *EXPERIMENT, "--jobs", "1", "--out", str(folder / "alone"))
        expected = results_of(folder / "alone")
        lookout(program, *EXPERIMENT, "--jobs", "2", "--out", str(folder / "threads"))
        assert results_of(folder / "threads") == expected, "two threads differ"
        shards = {}
        for count in (1, 4, 12):
            shards[count] = run_shards(program, folder, count)
            out = folder / f"merged{count}"
            lookout(program, "merge", *reversed(shards[count]), "--out", str(out))
            assert results_of(out) == expected, f"{count} shards differ"
        assert not (folder / "shard1of4" / "results.json").exists(), "a shard has results of its own"

        none = ["--out", str(folder / "none")]
        refused(program, "of 4 shards these are missing: 2", *(shards[4][k] for k in (0, 2, 3)), *none)
        refused(program, "is of another number of shards", shards[4][0], shards[12][1], *none)
        refused(program, "holds shard 1/4, and so does", *shards[4], shards[4][0], *none)
        other = str(folder / "other")
        lookout(program, *EXPERIMENT[:-1], "1001", "--shard", "2/4", "--out", other)
        refused(program, "is of another seed", shards[4][0], other, *none)
        lookout(program, *EXPERIMENT[:2], "--only", "method=fpht", *EXPERIMENT[6:], "--shard", "2/4", "--out", other)
        refused(program, "is of another command", shards[4][0], other, *none)
        log = pathlib.Path(shards[4][1]) / "runs.jsonl"
        log.write_text(log.read_text().replace('"commit":"', '"commit":"other-', 1))
        refused(program, "is of another commit", *shards[4], *none)
        assert not (folder / "none").exists(), "a refused merge left something"


if __name__ == "__main__":
    main()
