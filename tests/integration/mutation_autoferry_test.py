#!/usr/bin/python3
"""Damages an Autoferry-like pair at random and imports it, in this process: status 0 or 2, no exception, no trace of one in
what is said, nothing that is not finite in what is written. usage: mutation_autoferry_test.py [MUTATIONS [SEED]]"""
import contextlib
import io
import pathlib
import random
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import import_autoferry  # noqa: E402  (found only now)

CASES = ROOT / "tests" / "data" / "cases" / "autoferry_forms"
TOKENS = ["NaN", "Infinity", "-1", "1e308", "1e999", "9" * 400, "null", "true", '"x"', "[]", "{}", "[", "]", ",", ":", '"', "\0", "\xff"]
TRACES = ("Error", "Traceback", "Exception", "<class", "expected str")


def mutate(text, rng):
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(text) + 1)
        kind = rng.randrange(4)
        if kind == 0:
            text = text[:at] + text[at + rng.randint(1, 12):]
        elif kind == 1:
            text = text[:at] + rng.choice(TOKENS) + text[at:]
        elif kind == 2:
            end = at
            while end < len(text) and text[end] not in ",]}":
                end += 1
            text = text[:at] + rng.choice(TOKENS) + text[end:]
        else:
            text = text[:at] if rng.randrange(8) == 0 else text[:at] + text[max(0, at - 20):]
    return text


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 3000
    rng = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    good = [(CASES / f"{name}.json").read_text() for name in ("empty_d", "ok_g")]
    ended = {0: 0, 2: 0}
    memory = pathlib.Path("/dev/shm")  # a disk would take most of the time
    with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as name:
        folder = pathlib.Path(name)
        paths = [folder / "d.json", folder / "g.json"]
        for number in range(count):
            which = rng.randrange(2)
            for path, text in zip(paths, good):
                path.write_text(text)
            paths[which].write_text(mutate(good[which], rng), encoding="latin-1")
            said = io.StringIO()
            sys.argv = ["import_autoferry", *map(str, paths), str(folder / "out")]
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
                status = import_autoferry.main()
            written = "".join(p.read_text() for p in (folder / "out").glob("*.csv")) if status == 0 else ""
            if status not in ended or any(t in said.getvalue() for t in TRACES) or "nan" in written or "inf," in written:
                sys.exit(f"FAILED: mutation {number} of {paths[which].name}: status {status}: {said.getvalue()}")
            ended[status] += 1
    print(f"autoferry: {count} mutations: {ended[0]} read, {ended[2]} refused, 0 faults")


if __name__ == "__main__":
    main()
