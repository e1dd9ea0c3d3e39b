#!/usr/bin/python3
"""tools/plot_tracking.py on a single run, which has no interval: curves all the same."""
import pathlib
import sys
import tempfile

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"


def row(method, p_false_alarm, mean, paper):
    return {"method": method, "clutter": "light", "metric": "ospa_of_means", "sigma": "3", "p_miss": "0.1", "window_scans": "20",
            "p_false_alarm": p_false_alarm, "mean": mean, "ci95": "nan", "paper": paper}


def main():
    sys.path.insert(0, str(TOOLS))
    try:
        import plot_tracking
        from plot_style import Album
    except ModuleNotFoundError as error:
        if error.name not in ("numpy", "matplotlib", "cycler"):
            raise
        print(f"skipped: {error}")
        return 77
    rows = [row("csht", "0.1", "1.2", "1.8"), row("csht", "0.3", "1.4", "1.72"), row("kalman", "0.1", "2.8", "")]
    with tempfile.TemporaryDirectory() as directory:
        album = Album(directory)
        plot_tracking.plot_over_false_alarms(album, rows, "light", "ospa_of_means", "OSPA of the means [m]", "25")
        names = {path.name for path in pathlib.Path(directory).iterdir()}
        assert {"yan2018_fig25_light.png", "yan2018_fig25_light.pdf", "pictures.md"} <= names, names
    return 0


if __name__ == "__main__":
    sys.exit(main())
