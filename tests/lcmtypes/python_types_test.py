#!/usr/bin/python3
"""The Python types: what they encode they decode, what the program encoded they decode and encode to the same bytes, and
what they encode the program decodes. usage: python_types_test.py PYTHON_FOLDER LOOKOUT SCENE_WITH_IMAGES"""
import pathlib
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, sys.argv[1])
import lookout  # noqa: E402  (found only now)
import lookout_link  # noqa: E402

LOOKOUT, SCENE = sys.argv[2:4]
TYPES = {
    "VEHICLE_STATE": lookout.vehicle_state_t,
    "SONAR_SCAN": lookout.sonar_scan_t,
    "SONAR_IMAGE": lookout.sonar_image_t,
    "GROUND_TRUTH": lookout.ground_truth_t,
    "LOOKOUT_STATUS": lookout.node_status_t,
}


def expect(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def run(*words):
    result = subprocess.run([LOOKOUT, *map(str, words)], capture_output=True, text=True)
    expect(result.returncode == 0, f"{words}: {result.stderr}")
    return result.stderr


def filled(kind):
    """A message of `kind` with a value of its own in every field, lists of two."""
    message, number = kind(), 1
    for field in message.__slots__:
        value = getattr(message, field)
        if field.startswith("num_"):
            setattr(message, field, 2)
        elif field == "intensity" and kind is lookout.sonar_image_t:
            setattr(message, field, ((1, 2), (-3, 32767)))
        elif field == "density":
            setattr(message, field, ((0, 1), (20, 127)))
        elif field == "text" and kind is lookout.decisions_t:
            setattr(message, field, b"a\n")
        elif field in ("targets", "tracks", "elements"):
            part = {"targets": "target_truth_t", "tracks": "track_t", "elements": "motion_element_t"}[field]
            setattr(message, field, [filled(getattr(lookout, part)), filled(getattr(lookout, part))])
        elif field == "covariance" and value:
            setattr(message, field, tuple(tuple(4.0 * i + j for j in range(4)) for i in range(4)))
        elif isinstance(value, list):
            setattr(message, field, (0.5, -1.5))
        elif isinstance(value, str):
            setattr(message, field, f"text {number}")
        elif isinstance(value, bool):
            setattr(message, field, True)
        else:
            setattr(message, field, type(value)(number))
        number += 1
    return message


def as_plain(value):
    """Fields of a message as plain lists, whatever holds them."""
    if hasattr(value, "__slots__"):
        return [as_plain(getattr(value, field)) for field in value.__slots__]
    return [as_plain(entry) for entry in value] if isinstance(value, (list, tuple)) else value


def test_there_and_back():
    kinds = [getattr(lookout, name) for name in dir(lookout) if name.endswith("_t") and isinstance(getattr(lookout, name), type)]
    expect(len(kinds) == 15, f"{len(kinds)} types")
    for kind in kinds:
        message = filled(kind)
        expect(as_plain(kind.decode(message.encode())) == as_plain(message), f"{kind.__name__} there and back")
        try:
            kind.decode(b"\0" * 8 + message.encode()[8:])
            expect(False, f"{kind.__name__} takes another fingerprint")
        except ValueError:
            pass


def test_what_the_program_encodes(folder):
    log = folder / "sim.log"
    run("sim", SCENE, "--speed", "max", "--lcm-url", f"file://{log}?mode=w")
    seen = set()
    for channel, data in lookout_link.read_log(log):
        message = TYPES[channel].decode(data)
        expect(message.encode() == data, f"{channel} is encoded to the same bytes")
        seen.add(channel)
    expect(seen == set(TYPES), f"channels of the log: {seen}")


def test_what_the_program_decodes(folder):
    events = []
    for ping in range(3):
        state = lookout.vehicle_state_t()
        image = lookout.sonar_image_t()
        state.utime = image.utime = 100_000 * ping
        image.sequence = ping
        image.num_beams, image.num_bins = 3, 4
        image.bearing = [-0.2, 0.0, 0.3]
        image.first_range, image.range_step, image.intensity_scale = 0.5, 1.0, 0.25
        image.intensity = [[ping + 4 * beam + k for k in range(4)] for beam in range(3)]
        for channel, message in (("VEHICLE_STATE", state), ("SONAR_IMAGE", image)):
            events.append(lookout_link.log_event(len(events), state.utime, channel, message))
    (folder / "python.log").write_bytes(b"".join(events))
    said = run("replay", folder / "python.log", "--estimator", "h_pmht", "--out", folder / "out")
    expect("3 scans tracked" in said, said)
    rows = (folder / "out" / "images.csv").read_text().splitlines()
    expect(len(rows) == 4, f"images.csv: {rows}")
    picture = (folder / "out" / "images" / "000002.pgm").read_bytes()
    expect(struct.unpack(">12H", picture[-24:]) == tuple(range(2, 14)), "the pixels are those that were encoded")


def test_datagrams():
    """As in LCM's own sources: the channel stands in the first part alone, offsets count the data."""
    data = bytes(range(256)) * 1000
    parts = lookout_link.datagrams("SONAR_IMAGE", data, 7)
    expect(len(parts) == 4 and all(len(part) <= 65507 for part in parts), "256 kB are four datagrams")
    together = b""
    for number, part in enumerate(parts):
        magic, sequence, size, offset, index, count = struct.unpack(">IIIIHH", part[:20])
        expect((magic, sequence, size, index, count) == (0x4C433033, 7, len(data), number, 4), f"header of part {number}")
        expect(offset == len(together), f"offset of part {number}")
        together += part[20 + (len("SONAR_IMAGE") + 1 if number == 0 else 0) :]
    expect(together == data, "the parts are the message")
    expect(lookout_link.datagrams("A", b"xyz", 1) == [b"LC02\0\0\0\1A\0xyz"], "a small message is one")


def main():
    test_there_and_back()
    test_datagrams()
    with tempfile.TemporaryDirectory() as name:
        test_what_the_program_encodes(pathlib.Path(name))
        test_what_the_program_decodes(pathlib.Path(name))
    print("passed")


if __name__ == "__main__":
    main()
