#!/usr/bin/python3
"""tools/plot_sea.py on two conditions of four cells, one of them with a cell in which nothing came."""
import json
import pathlib
import sys
import tempfile

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
PATCH = "bearing_deg,range_m,true_db,joint_db,gnn_db\n-5,10,0,0,0\n-5,20,16,15,14\n5,10,,0,0\n5,20,1,0,3\n"
UNIFORM = "bearing_deg,range_m,true_db,joint_db\n-5,10,0,0\n-5,20,0,0\n5,10,0,0\n5,20,0,0\n"
PARAMETERS = {"targets": "near", "p_false_alarm": 0.1, "p_miss": 0.1, "sensor_figures": "unknown"}


def main():
    sys.path.insert(0, str(TOOLS))
    try:
        import plot_sea
    except ModuleNotFoundError as error:
        if error.name not in ("numpy", "matplotlib", "cycler"):
            raise
        print(f"skipped: {error}")
        return 77
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for condition, content in (("patch", PATCH), ("uniform", UNIFORM)):
            (directory / f"clutter_{condition}.csv").write_text(content)
            (directory / f"pictured_clutter_{condition}.json").write_text(json.dumps({"parameters": PARAMETERS, "seed": 1}))
        bearings, ranges, maps = plot_sea.maps_of(directory / "clutter_patch.csv")
        assert list(bearings) == [-10, 0, 10] and list(ranges) == [5, 15, 25], (bearings, ranges)
        assert list(maps) == ["true", "joint", "gnn"], list(maps)
        assert maps["true"][1, 0] == 16 and maps["true"][0, 1] < -1e9, maps["true"]  # a row a range, a column a bearing
        assert plot_sea.main(directory) == 0
        assert {"clutter_patch.png", "clutter_uniform.png", "pictures.md"} <= {path.name for path in directory.iterdir()}
    return 0


if __name__ == "__main__":
    sys.exit(main())
