"""What a directory of a run, a replay or anyone's recording holds, as far as plot_run.py draws it."""
import csv
import math
import re
import sys

import numpy as np

LARGEST = 1e100  # Of what can be drawn: matplotlib squares it.
KNOWN = {"time_s", "north_m", "east_m", "bearing_rad", "bearing_deg", "range_m", "x_px", "total"}  # Names of a header.


def warn(line):
    print(f"plot_run.py: {line}", file=sys.stderr)


def to_float(text):
    """A number that can be drawn, else nan."""
    try:
        value = float(text.replace("\u2212", "-"))
    except ValueError:
        return math.nan
    return value if abs(value) < LARGEST else math.nan


def names_of(line):
    """The names of a header line in small letters, and what separates them: whatever stands most often."""
    separator = max(",;\t|", key=line.count)
    return [name.strip().lower() for name in next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])], separator


def header_and_rows(text):
    """Names, separator and rows as docs/formats.md says: remarks behind `#`, `sep=;`, a header behind `#`."""
    lines = [line for line in text.replace("\0", "").splitlines() if line.strip() and not line.lower().startswith("sep=")]
    while lines and lines[0].lstrip().startswith("#") and not KNOWN & set(names_of(lines[0].strip(" #"))[0]):
        lines.pop(0)
    if not lines:
        return [], ",", []
    names, separator = names_of(lines[0].strip(" #"))
    body = [line for line in lines[1:] if not line.lstrip().startswith("#")]
    return names, separator, list(csv.reader(body, delimiter=separator, skipinitialspace=separator != "\t"))


class Table:
    """The columns of a CSV file as arrays of floats, what is no number as nan; texts of `status` as they are."""

    def __init__(self, path=None):
        self.columns = {}
        self.status = []
        if path is None or not path.is_file():
            return
        try:
            names, separator, rows = header_and_rows(path.read_text(encoding="utf-8-sig", errors="replace"))
        except (OSError, csv.Error) as error:
            warn(f"{path}: {error}")
            return
        for k, name in enumerate(names):
            values = [row[k].strip() if k < len(row) else "" for row in rows]
            if name == "status":
                self.status = [value.lower() for value in values]
            if separator != ",":
                values = [value.replace(",", ".") for value in values]
            self.columns[name] = np.array([to_float(value) for value in values])
        for name in [name for name in self.columns if name.endswith("_deg")]:
            self.columns.setdefault(name[:-4] + "_rad", np.radians(self.columns[name]))

    def __len__(self):
        return len(next(iter(self.columns.values()), ()))

    def __getitem__(self, name):
        return self.columns.get(name, np.full(len(self), np.nan))

    def has(self, *names):
        return len(self) > 0 and all(name in self.columns and np.isfinite(self[name]).any() for name in names)

    def sure(self):
        """Which rows are not of tentative tracks."""
        return np.array([status != "tentative" for status in self.status] or [True] * len(self), dtype=bool)


def read_sonar(path):
    """The plain `key: number` lines of sonar.yaml; of uneven beams the first and the mean step."""
    figures = {}
    if path.is_file():
        for line in path.read_text(errors="replace").splitlines():
            found = re.match(r"\s*(\w+)\s*:\s*(-?[\d.eE+-]+)\s*(#.*)?$", line)
            if found and math.isfinite(to_float(found.group(2))):
                figures[found.group(1)] = float(found.group(2))
            table = re.match(r"\s*beam_bearings_deg\s*:\s*\[([^\]]*)\]", line)
            beams = [to_float(text) for text in table.group(1).split(",")] if table else []
            if len(beams) > 1 and all(map(math.isfinite, beams)):
                figures["num_beams"] = len(beams)
                figures["first_bearing_deg"] = min(beams)
                figures["bearing_step_deg"] = (max(beams) - min(beams)) / (len(beams) - 1)
    return figures


NEEDED = {"scans": ("time_s", "bearing_rad", "range_m"), "vehicle": ("north_m", "east_m"), "truth": ("time_s", "north_m", "east_m"),
          "tracks": ("time_s", "north_m", "east_m"), "ospa": ("time_s", "total")}


def kind_of(table):
    """Which file of a directory a table stands for that came alone."""
    return next((kind for kind in ("scans", "ospa") if table.has(*NEEDED[kind])), "tracks")


class Run:
    """What a directory holds, or one file of returns, tracks or scores."""

    def __init__(self, path, scores):
        alone = Table(path) if path.is_file() else None
        self.in_pixels = alone is not None and alone.has("x_px", "y_px")
        if self.in_pixels:  # Tracks of an image sequence; y goes down.
            alone.columns.update(east_m=alone["x_px"], north_m=alone["y_px"])
        for kind in NEEDED:
            table = Table(path / f"{kind}.csv") if alone is None else alone if kind == kind_of(alone) else Table()
            setattr(self, kind, table)
        if scores and scores.is_file():
            self.ospa = Table(scores)
        self.sonar = read_sonar(path / "sonar.yaml")
        self.returns = self.placed_returns()

    def empty(self):
        return not (len(self.returns) or self.vehicle.has("north_m", "east_m") or self.ospa.has("time_s", "total")
                    or any(table.has("time_s", "north_m", "east_m") for table in (self.truth, self.tracks)))

    def lacks(self, path):
        """What the files lack that are there, for a person."""
        if path.is_file():
            return "expected columns time_s with bearing_rad or bearing_deg and range_m, or with north_m and east_m"
        parts = [f"{kind}.csv without a number in {', '.join(name for name in columns if not getattr(self, kind).has(name))}"
                 for kind, columns in NEEDED.items() if (path / f"{kind}.csv").is_file()]
        return "; ".join(parts) or f"expected {', '.join(f'{kind}.csv' for kind in NEEDED)}"

    def pose(self, times):
        """Vehicle north, east, heading at `times`; the origin, looking north, where there is no vehicle.csv."""
        vehicle = self.vehicle
        if not vehicle.has("time_s", "north_m", "east_m", "heading_rad"):
            return np.zeros((3, len(times)))
        good = np.isfinite(vehicle["time_s"]) & np.isfinite(vehicle["north_m"]) & np.isfinite(vehicle["east_m"])
        good &= np.isfinite(vehicle["heading_rad"])
        order = np.argsort(vehicle["time_s"][good], kind="stable")
        at = vehicle["time_s"][good][order]
        columns = [vehicle[name][good][order] for name in ("north_m", "east_m")]
        columns.append(np.unwrap(vehicle["heading_rad"][good][order]))
        return np.array([np.interp(times, at, column) for column in columns])

    def sonar_pose(self, times):
        north, east, heading = self.pose(times)
        forward, starboard = self.sonar.get("mount_x", 0.0), self.sonar.get("mount_y", 0.0)
        return np.array([north + forward * np.cos(heading) - starboard * np.sin(heading),
                         east + forward * np.sin(heading) + starboard * np.cos(heading),
                         heading + math.radians(self.sonar.get("mount_heading_deg", 0.0))])

    def placed_returns(self):
        """Time, north and east of every return, a row each."""
        scans = self.scans
        if not scans.has("time_s", "bearing_rad", "range_m"):
            return np.empty((0, 3))
        good = np.isfinite(scans["time_s"]) & np.isfinite(scans["bearing_rad"]) & np.isfinite(scans["range_m"])
        time, bearing, reach = (scans[name][good] for name in ("time_s", "bearing_rad", "range_m"))
        north, east, heading = self.sonar_pose(time)
        angle = heading + bearing
        return np.column_stack([time, north + reach * np.cos(angle), east + reach * np.sin(angle)])

    def fan_edges(self):
        """First and last bearing [rad] and range [m] of the sonar: of sonar.yaml, else of the returns."""
        keys = ("num_beams", "first_bearing_deg", "bearing_step_deg", "max_range")
        if all(key in self.sonar for key in keys):
            beams, first, step, reach = (self.sonar[key] for key in keys)
            return math.radians(first - step / 2), math.radians(first + (beams - 0.5) * step), reach
        if not self.scans.has("bearing_rad", "range_m"):
            return None
        bearing = self.scans["bearing_rad"]
        return np.nanmin(bearing), np.nanmax(bearing), np.nanmax(self.scans["range_m"])

    def times(self):
        """First and last time of anything that moves; nothing where there is no time at all."""
        all_times = [table["time_s"] for table in (self.scans, self.tracks, self.truth) if table.has("time_s")]
        finite = np.concatenate(all_times)[np.isfinite(np.concatenate(all_times))] if all_times else np.array([])
        return np.unique(finite)


def by_id(table, keep=None):
    """(id, rows) of each id, in order."""
    keep = np.ones(len(table), dtype=bool) if keep is None else keep
    identity = table["id"]
    kept = np.flatnonzero(keep & np.isfinite(table["north_m"]) & np.isfinite(table["east_m"]) & np.isfinite(identity))
    kept = kept[np.argsort(identity[kept], kind="stable")]
    for rows in np.split(kept, np.flatnonzero(np.diff(identity[kept])) + 1):
        if len(rows):
            yield int(identity[rows[0]]), rows


def longest(groups, most):
    """The `most` of (id, rows) that have the most rows, in order, and the rows of all others."""
    groups = list(groups)
    length = sorted((len(rows) for _, rows in groups), reverse=True)[most - 1] if len(groups) > most else 0
    longer = [group for group in groups if len(group[1]) > length]
    equal = [group for group in groups if len(group[1]) == length][:most - len(longer)]
    chosen = sorted(longer + equal, key=lambda group: group[0])
    names = {identity for identity, _ in chosen}
    others = [rows for identity, rows in groups if identity not in names]
    return chosen, np.concatenate(others) if others else np.array([], dtype=int)
