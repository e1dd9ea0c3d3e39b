#!/usr/bin/python3
"""tools/reproduce and tools/paper_tables.py: a page of one window comes out again, a changed figure is named, a page that
says too little is refused.

usage: reproduce_test.py LOOKOUT
"""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOOKOUT = sys.argv[1]
sys.path.insert(0, str(ROOT / "tools"))

import paper_tables  # noqa: E402

COMMAND = ["lookout", "experiment", "csht-window", "--runs", "3", "--seed", "1000", "--only", "method=csht", "--only",
           "clutter=light", "--only", "window_scans=20", "--only", "p_miss=0.1", "--only", "sigma=3", "--only", "p_false_alarm=0.1",
           "--only", "p_false_alarm=0.3"]


def check(condition, what):
    print(("ok: " if condition else "FAILED: ") + what)
    if not condition:
        sys.exit(1)


def reproduce(page, *words):
    words = words or ("--program", LOOKOUT, "--jobs", "1")
    return subprocess.run([ROOT / "tools/reproduce", page, *words], capture_output=True, text=True, check=False)


def page_of(folder, rows):
    chosen = [row for row in rows if row["metric"] == "position_ospa"]
    grid = paper_tables.as_markdown(paper_tables.grid(chosen, ["position_ospa"]))
    return (f"# A page\n\nCommit: 0000000 No such subject\n\n    {' '.join(COMMAND)} --out {folder}/window\n\n"
            f"<!-- grid window figures=position_ospa where=method=csht -->\n\n{grid}\n")


def check_grid():
    rows = [{"p_miss": m, "p_false_alarm": f, "metric": "ospa", "mean": float(m) + 10 * float(f), "ci95": 0.5, "paper": None}
            for m in ("0.1", "0.7") for f in ("0.3", "0.1")]
    lines = paper_tables.grid(rows, ["ospa"])
    check(lines[0] == ["P_M \\ P_F", "0.1", "0.3"], "columns are the false alarm rates, rising")
    check(lines[3] == ["0.7", "1.70 ± 0.50", "3.70 ± 0.50"], "a row is a miss rate")
    mean = paper_tables.listing(paper_tables.pooled(rows, ["p_miss"]), ["ospa"], ["p_miss"])
    check(mean[2:] == [["0.1", "2.10"], ["0.7", "2.70"]], f"cells are pooled to their mean: {mean[2:]}")


def main():
    check_grid()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out = folder / "first"
        subprocess.run([LOOKOUT, *COMMAND[1:], "--out", out], check=True, capture_output=True)
        report = (out / "report.md").read_text()
        check(f"{' '.join(COMMAND)} --out {out}" in report, "report.md prints the command that made it")
        page = folder / "page.md"
        text = page_of(folder, paper_tables.read_results(out / "results.csv"))
        page.write_text(text)
        same = reproduce(page)
        check(same.returncode == 0 and "all 2 figures equal" in same.stdout, f"the page comes out again: {same.stdout}{same.stderr}")
        out.rename(folder / "window")
        grids = text.replace("figures=position_ospa where", "figures=time_ms where")
        page.write_text(grids.replace(" ± ", " ± 9", 1))
        timed = reproduce(page, "--results", folder)
        check(timed.returncode == 0 and "all 0 figures equal" in timed.stdout, f"times are not compared: {timed.stdout}{timed.stderr}")
        page.write_text(text.replace(" ± ", " ± 9", 1))
        other = reproduce(page, "--results", folder)
        check(other.returncode == 1 and "1 of 2 figures differ" in other.stdout, "a changed figure is found")
        check("page.md:7: 0.1, 0.1: " in other.stdout, f"and named: {other.stdout}")
        reproduce(page, "--results", folder, "--write")
        check(page.read_text() == text, "--write puts the figure right")
        page.write_text(text.split("| P_M")[0] + "After.\n")
        reproduce(page, "--results", folder, "--write")
        check(page.read_text() == text + "\nAfter.\n", f"and fills an empty page: {page.read_text()}")
        unknown = subprocess.run([ROOT / "tools/reproduce", page], capture_output=True, text=True, check=False)
        check(unknown.returncode == 2 and "is not in this repository" in unknown.stderr, f"an unknown commit is told: {unknown.stderr}")
        page.write_text(text.replace("Commit: ", ""))
        refused = reproduce(page)
        check(refused.returncode == 2 and "expected a line `Commit:" in refused.stderr, "a page without a commit is refused")


if __name__ == "__main__":
    main()
