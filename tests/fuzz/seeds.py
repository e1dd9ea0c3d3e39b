#!/usr/bin/python3
"""Writes what the fuzz targets begin with, beside their kept corpus: files of this tree and pieces cut from them.

usage: tests/fuzz/seeds.py FOLDER, which gets a folder for each target that has seeds.
"""
import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "tests" / "data" / "cases"
SCENARIOS = ROOT / "tools" / "scenarios"
LOG_EVENT = struct.Struct(">IqqII")  # mark, number, time, lengths of channel and data
FINGERPRINT = 8  # bytes
LONGEST = 4096  # bytes of a seed
MOST_ROWS = 6  # of a table in one
# The first byte of wire_fuzz.cpp.
TYPES = {b"VEHICLE_STATE": 0, b"SONAR_SCAN": 1, b"SONAR_IMAGE": 2, b"GROUND_TRUTH": 3, b"MOTION_ELEMENTS": 4, b"TRACKS": 5,
         b"SENSOR_ESTIMATE": 6, b"LOCAL_ESTIMATE": 7, b"LOOKOUT_STATUS": 8, b"OSPA": 9}
# The first letter of recording_fuzz.cpp.
FILES = {"scans.csv": b"s", "vehicle.csv": b"v", "truth.csv": b"t", "sonar.yaml": b"y"}
TABLES = {
    "images": b"itime_s,clock,sensor_id,sequence,file,bearings,first_range_m,range_step_m,intensity_scale,zero_level\n0,0,0,0,images/000000.pgm,0,0,0.5,1,0\n",
    "bearings": b"btable,beam,bearing_rad\n0,0,-0.1\n0,1,0\n0,2,0.2\n",
    "geometry": b"gtime_s,sensor_id,num_beams,max_range_m\n0,0,60,50\n5,0,60,100\n",
    "tracks": b"ktime_s,id,status,north_m,east_m\n0,1,confirmed,40,10\n1,1,coasting,40,10\n",
}
CONFIGURATIONS = {
    "csht": "sensor: {range_sigma: 3.0, max_speed: 3.0}\nestimator: {name: csht, window_scans: 20}\n"
            "tracker: {name: csht, coast_s: 10.0, initiator: csht}\noutput: {min_existence: 0.5}\n",
    "fusion": "fusion: {support: any, unit: km, origin: zero, association: one_to_one}\n"
              "tbd: {dct_db: 5.0, truncation: zero, polarity: bright, start: [120.0, 80.0, 2.5, 0.0]}\n",
}
GEOMETRY = ("beam_bearings_deg: [-5, 0, 6]\nmin_range: 1\nmax_range: 4\nping_period: 0.1\nrows: beams\nranges_from: near\n"
            "mount_x: 1.0\n")
PICTURES = {"binary": b"P5\n4 3\n255\nabcdefghijkl", "wide": b"P5 2 1 65535\n\0\1\2\3", "plain": b"P2\n# four\n2 2\n99\n1 2\n3 4\n"}


def events(log):
    """(channel, data) of each event of a log."""
    data, at = log.read_bytes(), 0
    while at + LOG_EVENT.size <= len(data):
        _, _, _, channel_size, size = LOG_EVENT.unpack_from(data, at)
        begin = at + LOG_EVENT.size + channel_size
        yield data[at + LOG_EVENT.size : begin], data[begin : begin + size]
        at = begin + size


def oculus_packet(beams=4, ranges=3):
    """A simple ping of version 1, by the layout of docs/import.md."""
    size = 122 + 2 * beams + 6 + beams * ranges
    packet = bytearray(size)
    for at, layout, value in [(0, "<H", 0x4F53), (6, "<H", 0x23), (8, "<H", 1), (10, "<I", size - 16), (53, "<I", 1000),
                              (61, "<d", 2.1e6), (85, "<d", 1500.0), (93, "<I", 500_000_000), (98, "<d", 0.25),
                              (106, "<HH", (ranges, beams)), (110, "<III", (size - beams * ranges, beams * ranges, size)),
                              (122, "<4h", (-1500, -200, 0, 2000))]:
        struct.pack_into(layout, packet, at, *(value if isinstance(value, tuple) else (value,)))
    return bytes(packet)


class Seeds:
    """The folder that they go to."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def add(self, target, name, content):
        (self.folder / target).mkdir(parents=True, exist_ok=True)
        (self.folder / target / name).write_bytes(content[:LONGEST])

    def add_logs(self):
        for log in sorted(CASES.glob("*.lcmlog")):
            self.add("log", log.stem, log.read_bytes())
            for tracker in range(3):
                self.add("chain", f"{log.stem}_{tracker}", bytes([tracker]) + log.read_bytes())
            for number, (channel, data) in enumerate(events(log)):
                if number < 6 and channel in TYPES:
                    self.add("wire", f"{log.stem}_{number}", bytes([TYPES[channel]]) + data[FINGERPRINT:])

    def add_texts(self):
        for scene in sorted(SCENARIOS.glob("*.yaml")):
            self.add("scene", scene.stem, scene.read_bytes())
        for plan in sorted((SCENARIOS / "faults").glob("*.yaml")):
            self.add("fault_plan", plan.stem, plan.read_bytes())
        for form in sorted((CASES / "yaml_forms").glob("*.yaml")):
            self.add("configuration", form.stem, form.read_bytes())
        for name, text in CONFIGURATIONS.items():
            self.add("configuration", name, text.encode())

    def add_recordings(self):
        for file in sorted(CASES.rglob("*")):
            if file.name in FILES:
                rows = file.read_bytes().splitlines(keepends=True)[:MOST_ROWS]
                self.add("recording", f"{file.parent.name}_{file.stem}", FILES[file.name] + b"".join(rows))
        for name, table in TABLES.items():
            self.add("recording", name, table)
        for name, picture in PICTURES.items():
            self.add("pgm", name, picture)

    def add_imports(self):
        forms = CASES / "autoferry_forms"
        pair = [(forms / name).read_bytes()[:1900] for name in ("empty_d.json", "ok_g.json")]
        self.add("import_autoferry", "pair", b"%%%\n".join(pair))
        self.add("import_autoferry", "small", b'[{"t": 1}]\n%%%\n[{"t": 1}]\n')
        self.add("import_oculus", "ping", oculus_packet())
        self.add("import_pgm", "geometry", GEOMETRY.encode())


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tests/fuzz/seeds.py FOLDER")
    seeds = Seeds(sys.argv[1])
    seeds.add_logs()
    seeds.add_texts()
    seeds.add_recordings()
    seeds.add_imports()


if __name__ == "__main__":
    main()
