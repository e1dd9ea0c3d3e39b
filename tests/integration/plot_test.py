#!/usr/bin/python3
"""Pictures of a run, of its parts, of a log and of what is damaged: `lookout plot` and tools/plot_run.py behind it.

usage: plot_test.py LOOKOUT SCENARIO. Status 77 where matplotlib is missing.
"""
import importlib
import itertools
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOOKOUT, SCENARIO = sys.argv[1:3]
MAGIC = {".png": b"\x89PNG", ".pdf": b"%PDF", ".gif": b"GIF8"}


def lookout(*words):
    return subprocess.run([LOOKOUT, *map(str, words)], capture_output=True, text=True, check=False)


def is_picture(path):
    return path.is_file() and path.read_bytes().startswith(MAGIC[path.suffix]) and path.stat().st_size > 2000


def short_scene(folder):
    """The first ten seconds of the scenario: a picture of them has all that a longer one has."""
    scene = folder / "scene.yaml"
    text, changed = re.subn(r"^duration: .*", "duration: 10.0", pathlib.Path(SCENARIO).read_text(), flags=re.MULTILINE)
    check(changed == 1, "the scenario says how long it is")
    scene.write_text(text)
    return scene


def check(condition, what):
    print(("ok: " if condition else "FAILED: ") + what)
    if not condition:
        sys.exit(1)


def plot_run_module():
    """The script as a module that draws small pictures."""
    sys.path.insert(0, str(ROOT / "tools"))
    try:
        module = importlib.import_module("plot_run")
    except SystemExit as error:
        print(f"SKIPPED: {error}")
        sys.exit(77)
    module.DOTS_PER_INCH = 20
    return module


def draw(module, directory, path):
    """The exit status of the script, in this process; whatever it throws is thrown here."""
    sys.argv = ["plot_run.py", str(directory), str(path)]
    return module.main()


def check_run(run):
    result = lookout("plot", run)
    check(result.returncode == 0, f"a run is drawn: {result.stderr.strip()}")
    check(is_picture(run / "lookout.png") and is_picture(run / "lookout.pdf"), "PNG and PDF lie beside it")
    result = lookout("plot", run, "--out", run / "film.gif")
    check(result.returncode == 0 and is_picture(run / "film.gif"), "an animation on request")


def check_images(folder):
    (folder / "in").mkdir()
    (folder / "in" / "geometry.yaml").write_text("beam_bearings_deg: [-20, -5, 0, 12]\nrange_step: 0.5\nping_period: 0.1\n")
    for k in range(3):
        (folder / "in" / f"ping{k}.pgm").write_bytes(b"P5\n6 4\n255\n" + bytes(20 + 10 * k + i for i in range(24)))
    check(lookout("import", "pgm", folder / "in", "--out", folder / "images").returncode == 0, "pictures are imported")
    result = lookout("plot", folder / "images", "--animate")
    check(result.returncode == 0, f"images alone are drawn: {result.stderr.strip()}")
    check(all(is_picture(folder / "images" / f"lookout{end}") for end in MAGIC), "as picture and animation")
    (folder / "images" / "bearings.csv").write_text("table,beam\n")
    check(lookout("plot", folder / "images").returncode == 2, "what cannot be drawn is told")


def check_log(scene, folder):
    log = folder / "a.lcmlog"
    lookout("sim", scene, "--lcm-url", f"file://{log}?mode=w", "--speed", "max")
    result = lookout("plot", log)
    check(result.returncode == 0 and is_picture(folder / "a.lcmlog.png"), f"the log of sim is drawn: {result.stderr.strip()}")


def check_parts(module, run, folder):
    names = ["scans.csv", "vehicle.csv", "truth.csv", "tracks.csv", "ospa.csv", "sonar.yaml"]
    some = [set(names) - {name} for name in names] + [{name} for name in names]
    for kept, cut in itertools.chain(((kept, False) for kept in some), [(set(names), True)]):
        part = pathlib.Path(tempfile.mkdtemp(dir=folder))
        for name in kept:
            text = (run / name).read_text()
            (part / name).write_text(text[: len(text) // 3] if cut else text)
        status = draw(module, part, part / "a.png")
        drawn = kept != {"sonar.yaml"}
        check(status == (0 if drawn else 2) and is_picture(part / "a.png") == drawn, f"{'cut ' if cut else ''}{sorted(kept)}")


def check_oddities(module, folder):
    odd = folder / "odd"
    odd.mkdir()
    (odd / "tracks.csv").write_text("time_s,id,north_m,east_m\n0,1,1,2\n1,1,x,3\n2,1\n3,,4,5\nnan,2,inf,0\n")
    check(draw(module, odd, odd / "a.png") == 0, "rows that say nothing are left out")
    (odd / "tracks.csv").write_text("time_s;id;north_m;east_m\r\n0,5;1;1,5;2,5\r\n")
    (odd / "scans.csv").write_bytes(b"\xef\xbb\xbftime_s,bearing_rad,range_m,intensity\n0,0.1,30,1\n1,,,\n")
    check(draw(module, odd, odd / "b.png") == 0, "another country's CSV, returns without vehicle poses")
    check(draw(module, odd, odd / "b.gif") == 0, "and its animation")
    (odd / "scans.csv").write_text("time_s,bearing_deg,range_m\n0,90,30\n1,90,31\n")
    (odd / "vehicle.csv").write_text("time_s,north_m,east_m,heading_deg\n0,0,0,90\n")
    check(draw(module, odd, odd / "d.png") == 0, "angles in degrees")
    places = importlib.import_module("plot_run_tables").Run(odd, None).returns
    check(abs(places[0, 1] + 30) < 1e-9 and abs(places[0, 2]) < 1e-9, f"abeam of a vehicle that looks east is south: {places[0]}")
    (odd / "tracks.csv").write_bytes(bytes(range(256)) * 20)
    check(draw(module, odd, odd / "c.png") == 0, "no CSV at all beside it")


def check_alone(module, folder):
    """Someone's CSV without truth and without poses: returns from the origin, tracks, tracks without identity, in pixels."""
    contents = {"returns.csv": "# a sonar on a quay\nTime_s\tBearing_deg\tRange_m\n0\t10\t30\n1\t11\t31\n# the end\n2\t\u22122\t32\n",
                "tracks.csv": "time_s,id,north_m,east_m\n0,1,1,2\n1,1,2,3\n", "places.CSV": "time_s,north_m,east_m\n0,1,2\n1,2,3\n",
                "pixels.csv": "time_s,id,x_px,y_px,vx_px,vy_px,existence\n2,1,70,49,0,0,0.9\n3,1,71,50,0,0,0.9\n"}
    for name, text in contents.items():
        (folder / name).write_text(text, encoding="utf-8")
        check(draw(module, folder / name, folder / f"{name}.png") == 0 and is_picture(folder / f"{name}.png"), f"{name} alone")
    check(draw(module, folder / "pixels.csv", folder / "pixels.gif") == 0, "and as an animation")
    returns = importlib.import_module("plot_run_tables").Run(folder / "returns.csv", None).returns
    check(len(returns) == 3 and abs(returns[2, 2] + 32 * math.sin(math.radians(2))) < 1e-9, f"as the table says: {returns}")
    result = lookout("plot", folder / "places.CSV", "--out", folder / "alone.png")
    check(result.returncode == 0 and is_picture(folder / "alone.png"), f"by the program: {result.stderr.strip()}")
    (folder / "none.csv").write_text("a,b\n1,2\n")
    check(draw(module, folder / "none.csv", folder / "none.png") == 2, "a CSV that says nothing of ours is told")


def check_many(module, folder):
    """Thousands of identities take seconds, not minutes; what no picture can show is left out without a word of matplotlib's."""
    rows = [f"{k // 10},{k},{k % 777},{k % 333}" for k in range(3000)] + [f"{k},7000,{k},{k}" for k in range(20)]
    (folder / "many.csv").write_text("\n".join(["time_s,id,north_m,east_m", "0,1,1e308,-1e308", *rows]) + "\n")
    tables = importlib.import_module("plot_run_tables")
    table = tables.Run(folder / "many.csv", None).tracks
    groups = list(tables.by_id(table))
    check(len(groups) == 3001 and sum(len(rows) for _, rows in groups) == 3020, "each identity has its rows")
    chosen, others = tables.longest(groups, 200)
    check(len(chosen) == 200 and chosen[-1][0] == 7000 and len(others) == 3020 - 199 - 20, "the longest are told apart")
    result = lookout("plot", folder / "many.csv", "--out", folder / "many.png")
    check(result.returncode == 0 and result.stderr.count("\n") == 1, f"in one line: {result.stderr.strip()}")


def check_full_disk(folder):
    """Where no byte can be written: status 1, nothing left behind."""
    (folder / "few.csv").write_text("time_s,id,north_m,east_m\n0,1,1,2\n")
    limited = f"ulimit -f 1; trap '' XFSZ; exec '{LOOKOUT}' plot '{folder}/few.csv' --out '{folder}/cut.png'"
    result = subprocess.run(["bash", "-c", limited], capture_output=True, text=True, check=False)
    check(result.returncode != 0 and not list(folder.glob("*cut*")), f"no part of a picture stays: {result.stderr.strip()}")


def check_without_matplotlib(run, folder):
    """A Python that has no matplotlib: one clear line."""
    (folder / "bare").mkdir()
    (folder / "bare" / "matplotlib.py").write_text("raise ImportError(\"No module named 'matplotlib'\")\n")
    result = subprocess.run([LOOKOUT, "plot", str(run)], capture_output=True, text=True, check=False,
                            env={**os.environ, "PYTHONPATH": str(folder / "bare")})
    check(result.returncode != 0 and "install python3-numpy and python3-matplotlib" in result.stderr and "Traceback" not in result.stderr,
          f"without matplotlib a line says what to install: {result.stderr.strip()}")


def check_usage(run):
    for words in (["plot", "/no/such"], ["plot", run, "--out", "a.jpg"], ["plot", ROOT / "README.md"], ["plot", run, "--cutoff", "0"],
                  ["plot", ROOT / "docs"], ["plot", run, "--channel-prefix", "A_"], ["plot", run, "--out", "/no/such/a.png"]):
        result = lookout(*words)
        check(result.returncode == 2 and result.stderr.count("\n") == 1, f"status 2, one line: {result.stderr.strip()}")


def main():
    module = plot_run_module()
    folder = pathlib.Path(tempfile.mkdtemp())
    try:
        run, scene = folder / "run", short_scene(folder)
        check(lookout("run", scene, "--tracker", "csht", "--estimator", "ransac", "--out", run).returncode == 0, "a run")
        check_usage(run)
        check_run(run)
        check_log(scene, folder)
        check_images(folder)
        check_parts(module, run, folder)
        check_oddities(module, folder)
        check_alone(module, folder)
        check_many(module, folder)
        check_full_disk(folder)
        check_without_matplotlib(run, folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print("passed")


if __name__ == "__main__":
    main()
