#!/usr/bin/python3
"""tools/plot_initiators.py on small results: one clutter alone, and K of N kept apart."""
import importlib.util
import json
import pathlib
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "plot_initiators.py"


def load():
    sys.path.insert(0, str(SCRIPT.parent))  # plot_style stands beside it
    spec = importlib.util.spec_from_file_location("plot_initiators", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def cell(clutter, window, plots, p2):
    return {"method": "vct", "paper": {},
            "parameters": {"scans": 4, "window_scans": window, "min_plots": plots, "clutter_per_scan": clutter,
                           "detection_probability": 1},
            "metrics": {name: {"mean": value} for name, value in
                        {"p1": 1.0, "p2": p2, "p3": 0.1, "time_ms": 0.05}.items()}}


def run_on(module, cells):
    with tempfile.TemporaryDirectory() as directory:
        (pathlib.Path(directory) / "results.json").write_text(json.dumps({"cells": cells}))
        sys.argv = [str(SCRIPT), directory]
        module.main()
        return sorted(path.name for path in pathlib.Path(directory).iterdir())


def main():
    try:
        module = load()
    except ModuleNotFoundError as error:
        if error.name not in ("numpy", "matplotlib"):
            raise
        print(f"skipped: {error}")
        return 77
    # As after `--only clutter_per_scan=120 --only scans=4`: two cells, one clutter.
    one_clutter = [cell(120, 4, 4, 0.99), cell(120, 4, 3, 0.98)]
    assert "p2_against_clutter.png" not in run_on(module, one_clutter)
    assert {"table.png", "table.pdf", "pictures.md"} <= set(run_on(module, one_clutter))
    # 4 of 4 and 4 of 5 at two clutters: two curves of two points.
    apart = [cell(clutter, window, 4, 0.9) for clutter in (60, 120) for window in (4, 5)]
    assert sorted(len(curve) for curve in module.curves_of(apart).values()) == [2, 2]
    assert "p2_against_clutter.png" in run_on(module, apart)
    assert module.growth_exponent([(120, 1.0), (120, 2.0)]) is None
    assert abs(module.growth_exponent([(10, 1.0), (100, 100.0)]) - 2.0) < 1e-12  # time ~ clutter^2
    return 0


if __name__ == "__main__":
    sys.exit(main())
