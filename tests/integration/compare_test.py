#!/usr/bin/python3
"""Computes every figure of a comparison again from curves.csv, with SciPy, and compares threads and shards.

Usage: compare_test.py LOOKOUT SCENES_DIR [RUNS], a cell, of a comparison of two scenes and four methods. Exits 77 where NumPy or SciPy is not installed.
"""
import collections
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from scipy import stats
except ImportError:
    print("skipped: python3-numpy and python3-scipy are needed (tools/setup installs them)")
    sys.exit(77)

RUNS = 4
METHODS = ["gnn", "jipda", "gm_phd", "pmbm"]
DIMENSIONS = 4  # of a track's state
KEYS = ("scene", "method", "run", "time_s")
FILES = ("curves.csv", "means.csv", "results.json", "table.tex", "report.html")
CLOSE = {"rel_tol": 1e-8, "abs_tol": 1e-9}  # quantiles of two libraries agree to 2e-9


def lookout(program, *words):
    subprocess.run([program, *words], check=True, capture_output=True)


def read_curves(path):
    """{(scene, method): {run: {column: array over scans}}}, NaN for a blank."""
    runs = collections.defaultdict(lambda: collections.defaultdict(lambda: collections.defaultdict(list)))
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            run = runs[row["scene"], row["method"]][int(row["run"])]
            for name, text in row.items():
                if name == "time_s" or name not in KEYS:
                    run[name].append(float(text) if text else math.nan)
    return {cell: {run: {name: np.array(values) for name, values in columns.items()} for run, columns in of_cell.items()}
            for cell, of_cell in runs.items()}


def reduced(run, name, kind, order):
    values = run[name]
    there = ~np.isnan(values)
    if kind == "last":
        return values[-1]
    if not there.any():
        return math.nan
    if kind == "mean":
        return values[there].mean()
    if kind == "power_mean":
        return (values[there] ** order).mean() ** (1 / order)
    return np.average(values[there], weights=run["nees_pairs"][there])


def interval(values):
    values = np.asarray(values)[~np.isnan(values)]
    count = len(values)
    half = stats.t.ppf(0.975, count - 1) * values.std(ddof=1) / math.sqrt(count) if count > 1 else math.nan
    return {"mean": values.mean(), "ci95": half, "runs": count} if count else None


def over_time(runs, name):
    """{time: (mean, half width, count, low, high)}."""
    values, pairs = collections.defaultdict(list), collections.defaultdict(list)
    for run in runs.values():
        for time, value, count in zip(run["time_s"], run[name], run["nees_pairs"]):
            if not math.isnan(value):
                values[time].append(value)
                pairs[time].append(count)
    points = {}
    for time, there in values.items():
        if name == "nees":
            total = sum(pairs[time])
            low, high = (stats.chi2.ppf(q, DIMENSIONS * total) / (DIMENSIONS * total) for q in (0.025, 0.975))
            points[time] = (np.average(there, weights=pairs[time]), math.nan, total, low, high)
        else:
            estimate = interval(there)
            points[time] = (estimate["mean"], estimate["ci95"], estimate["runs"], math.nan, math.nan)
    return points


def holm(p_values):
    order = np.argsort(p_values, kind="stable")
    corrected, largest = np.empty(len(order)), 0.0
    for rank, i in enumerate(order):
        largest = max(largest, p_values[i] * (len(order) - rank))
        corrected[i] = min(1.0, largest)
    return corrected


def paired(first, second):
    difference = np.array(first) - np.array(second)
    there = ~np.isnan(difference)
    estimate = interval(difference)
    deviation = difference[there].std(ddof=1)
    if deviation == 0:
        zero = estimate["mean"] == 0
        return estimate, 0.0 if zero else math.inf, 0.0 if zero else math.inf, 1.0 if zero else 0.0
    t, p = stats.ttest_rel(np.array(first)[there], np.array(second)[there])
    return estimate, estimate["mean"] / deviation, t, p


def recompute(results, curves):
    order = results["score"]["order"]
    columns = results["columns"]
    values = {cell: {name: [reduced(run, name, column["over_scans"], order) for _, run in sorted(runs.items())]
                     for name, column in columns.items()} for cell, runs in curves.items()}
    cells = []
    for scene in results["scenes"]:
        for method in results["methods"]:
            metrics = {name: interval(values[scene, method][name]) for name in columns}
            nees = over_time(curves[scene, method], "nees").values()
            inside = np.mean([low <= mean <= high for mean, _, _, low, high in nees]) if nees else math.nan
            cells.append({"method": method, "parameters": {"scene": scene}, "nees_in_bounds": inside,
                          "metrics": {name: metric for name, metric in metrics.items() if metric}})
    tests = []
    for scene in results["scenes"]:
        for name in (name for name, column in columns.items() if column["tested"]):
            for a, first in enumerate(results["methods"]):
                for second in results["methods"][a + 1:]:
                    estimate, effect, t, p = paired(values[scene, first][name], values[scene, second][name])
                    tests.append({"scene": scene, "metric": name, "first": first, "second": second,
                                  "runs": estimate["runs"], "difference": estimate["mean"], "ci95": estimate["ci95"],
                                  "effect": effect, "t": t, "p": p})
    for test, corrected in zip(tests, holm([test["p"] for test in tests])):
        test["p_holm"] = corrected
    return {"cells": cells, "tests": tests}


def same(ours, theirs, where):
    if isinstance(theirs, dict):
        assert ours.keys() == theirs.keys(), f"{where}: {ours.keys()} and {theirs.keys()}"
        for key in theirs:
            same(ours[key], theirs[key], f"{where}/{key}")
    elif isinstance(theirs, list):
        assert len(ours) == len(theirs), where
        for i, (a, b) in enumerate(zip(ours, theirs)):
            same(a, b, f"{where}/{i}")
    elif isinstance(theirs, str):
        assert ours == theirs, f"{where}: {ours} and {theirs}"
    elif ours is None:
        assert not math.isfinite(theirs), f"{where}: nothing and {theirs}"
    else:
        assert math.isclose(ours, theirs, **CLOSE), f"{where}: {ours} and {theirs}"


def shown_as(text, value):
    """Whether `text` is `value` to the digits that it shows."""
    mantissa, _, exponent = text.partition("e")
    digits = len(mantissa.partition(".")[2])
    return abs(float(text) - value) <= 0.5001 * 10.0 ** (int(exponent or 0) - digits)


def check_report(directory, recomputed):
    text = (directory / "report.html").read_text()
    figures = re.findall(r'<data value="([^"]+)">([^<]+)</data>', text)
    assert len(figures) > 200, len(figures)
    for path, shown in figures:
        value = recomputed
        for key in path.split("/"):
            value = value[int(key) if isinstance(value, list) else key]
        assert shown_as(shown, value), f"{path}: {shown} for {value}"
    for cell in re.findall(r"<td[^>]*>(.*?)</td>", text):
        rest = re.sub(r"<data.*?</data>", "", cell)
        assert not re.search(r"\d\.\d", rest), f"a figure of no known origin: {cell}"
    assert not re.search(r"<(link|script|a )|src=\"(?!data:)|url\(", text), "the report needs the network"
    assert text.count("data:image/png;base64,") == 2, "a picture is missing"


def check_tex(directory, results, recomputed):
    text = (directory / "table.tex").read_text().replace("\\_", "_")
    names = re.search(r"method & (.*) \\\\", text)[1].split(" & ")
    rows = [line.removesuffix(" \\\\").split(" & ") for line in text.splitlines() if line.split(" & ")[0] in METHODS]
    assert len(rows) == len(recomputed["cells"])
    for row, cell in zip(rows, recomputed["cells"]):
        assert row[0] == cell["method"]
        for name, figure in zip(names, row[1:]):
            mean, half = figure.strip("$").split(" \\pm ")
            assert shown_as(mean, cell["metrics"][name]["mean"]) and shown_as(half, cell["metrics"][name]["ci95"]), figure


def check_means(directory, curves):
    with open(directory / "means.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    known = {}
    for row in rows:
        key = row["scene"], row["method"], row["metric"]
        if key not in known:
            known[key] = over_time(curves[key[:2]], key[2])
        expected = known[key].pop(float(row["time_s"]))
        shown = [float(row[name]) if row[name] else None for name in ("mean", "ci95", "runs", "bound_low", "bound_high")]
        same(shown, list(expected), f"means.csv {key} {row['time_s']}")
    assert not any(known.values()), "means.csv lacks times"


def check_same_bytes(one, other):
    pictures = [path.name for path in one.iterdir() if path.suffix in (".png", ".pdf")]
    assert len(pictures) == 4, pictures
    for name in (*FILES, *pictures):
        assert (one / name).read_bytes() == (other / name).read_bytes(), f"{name} of {other} differs"


def check_first_run(program, scene, directory, curves):
    """Run 0 of the comparison scores what `lookout run` scores; gnn draws nothing."""
    out = directory / "run"
    lookout(program, "run", str(scene), "--tracker", "gnn", "--seed", "1000", "--out", str(out))
    summary = json.loads((out / "summary.json").read_text())["ospa"]
    ours = curves[scene.stem, "gnn"][0]["ospa"]
    assert len(ours) == summary["times"]
    assert math.isclose(ours.mean(), summary["total"], abs_tol=1e-6), (ours.mean(), summary["total"])


def main():
    program, scenes, runs = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3] if len(sys.argv) > 3 else str(RUNS)
    files = [str(scenes / "crossing.yaml"), str(scenes / "overtaking.yaml")]
    words = ["compare", *files, *(word for method in METHODS for word in ("--method", method)),
             "--runs", runs, "--seed", "1000"]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        alone = folder / "alone"
        lookout(program, *words, "--jobs", "1", "--out", str(alone))
        results = json.loads((alone / "results.json").read_text())
        curves = read_curves(alone / "curves.csv")
        recomputed = recompute(results, curves)
        same(results["cells"], recomputed["cells"], "cells")
        same(results["tests"], recomputed["tests"], "tests")
        check_means(alone, curves)
        check_report(alone, recomputed)
        check_tex(alone, results, recomputed)
        check_first_run(program, scenes / "crossing.yaml", folder, curves)
        lookout(program, *words, "--jobs", "2", "--out", str(folder / "threads"))
        check_same_bytes(alone, folder / "threads")
        shards = [str(folder / f"shard{k}") for k in (1, 2, 3)]
        for k, out in enumerate(shards, 1):
            lookout(program, *words, "--shard", f"{k}/3", "--out", out)
        lookout(program, "merge", *shards, "--out", str(folder / "merged"))
        check_same_bytes(alone, folder / "merged")


if __name__ == "__main__":
    main()
