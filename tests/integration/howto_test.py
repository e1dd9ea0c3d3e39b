#!/usr/bin/python3
"""Runs the ten journeys of docs/howto.md as they stand there, with fewer runs, and looks at what they leave.

Usage: howto_test.py BUILD_DIR SOURCE_DIR [JOURNEY_NUMBER...]
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"```\w*\n(.*?)```", re.DOTALL)
FILE = re.compile(r"(?:#|//) file: (\S+)\n")
# What a full journey takes and the test need not: long scenes, many runs, a whole table, packages from the network.
SHORT_SCENE = (r"^duration: .*", "duration: 10.0")
SHORTER = [(r"--runs \d+", "--runs 2"), (r"--only p_miss=0.1", "--only p_miss=0.1 --only p_false_alarm=0.1 --only clutter=light"),
           (r"begin_nats=8:14", "begin_nats=8:14:6"), (r"(lookout sim .*)", r"\1 --duration 4"),
           (r"(tools/cluster) ", r"\1 --shards 3 "), (r"tools/setup .*", "true")]
MOST_COMMANDS = 3
MOST_SECONDS = 200
# What each journey must leave, besides ending well.
LEAVES = {1: ["out/first/tracks.csv", "out/first/lookout.png"], 2: ["out/window/report.md", "out/window/yan2018_fig08.png"],
          3: ["out/compare/report.html", "out/compare/table.tex", "out/compare/crossing.pdf"], 4: ["out/gospa.csv"],
          5: ["out/mine/tracks.csv"], 6: ["out/tune/sweep.csv", "out/tune/sweep.png"], 7: ["out/own/report.html"],
          8: ["out/own_sonar/tracks.csv", "out/own_sonar/lookout.png"], 9: ["out/many/results.json"], 10: []}


def journeys(page):
    """{number: (text)} and the text before the first."""
    parts = re.split(r"^## (\d+)\. ", page, flags=re.MULTILINE)
    return parts[0], {int(number): text for number, text in zip(parts[1::2], parts[2::2])}


def write_files(text, folder):
    for block in BLOCK.findall(text):
        named = FILE.match(block)
        if named:
            path = folder / named[1]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(re.sub(*SHORT_SCENE, block[named.end():], flags=re.MULTILINE))


def link_tools(source, folder):
    """The tools as they are, but for the scene that journeys name, which is short."""
    (folder / "tools/scenarios").mkdir(parents=True)
    for path in (source / "tools").iterdir():
        if path.name != "scenarios":
            (folder / "tools" / path.name).symlink_to(path)
    scene = pathlib.Path("tools/scenarios/crossing.yaml")
    (folder / scene).write_text(re.sub(*SHORT_SCENE, (source / scene).read_text(), flags=re.MULTILINE))


def commands_of(text):
    lines = [line for block in re.findall(r"```sh\n(.*?)```", text, re.DOTALL) for line in block.splitlines() if line.strip()]
    assert 0 < len(lines) <= MOST_COMMANDS, f"{len(lines)} commands: {lines}"
    return lines


def in_private_network(script):
    """A network of its own, in which multicast needs no permission and no port is taken."""
    return ["unshare", "-rn", "sh", "-c", "ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec bash -c \"$0\"", script]


def missing_for(number):
    if number == 9 and not shutil.which("parallel"):
        return "GNU parallel is missing (tools/setup --with-cluster installs it)"
    if number == 10 and subprocess.run(in_private_network("true"), capture_output=True).returncode != 0:
        return "this machine allows no network namespaces"
    return None


def run(number, text, folder, environment):
    write_files(text, folder)
    script = "set -e\n" + "\n".join(commands_of(text)) + "\nwait\n"
    for long, short in SHORTER:
        script = re.sub(long, short, script)
    command = in_private_network(script) if number == 10 else ["bash", "-c", script]
    done = subprocess.run(command, cwd=folder, env=environment, text=True, timeout=MOST_SECONDS,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    assert done.returncode == 0, f"journey {number} failed:\n{script}\n{done.stdout[-3000:]}"
    for name in LEAVES[number]:
        assert (folder / name).is_file(), f"journey {number} left no {name}:\n{done.stdout[-3000:]}"
    if number == 5:
        assert len((folder / "out/mine/tracks.csv").read_text().splitlines()) > 1, "the detections gave no track"
    return done.stdout


def main():
    build, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    head, all_journeys = journeys((source / "docs/howto.md").read_text())
    assert sorted(all_journeys) == list(range(1, 11)), f"not ten journeys: {sorted(all_journeys)}"
    chosen = [int(word) for word in sys.argv[3:]] or sorted(all_journeys)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        link_tools(source, folder)
        (folder / "build").symlink_to(build)
        (folder / "out").mkdir()
        write_files(head, folder)
        environment = dict(os.environ, PATH=f"{build}:{os.environ['PATH']}", LOOKOUT_TOOLS=str(source / "tools"), HOME=str(folder))
        for number in chosen:
            reason = missing_for(number)
            print(f"journey {number}: " + (f"skipped: {reason}" if reason else "runs"), flush=True)
            if not reason:
                run(number, all_journeys[number], folder, environment)


if __name__ == "__main__":
    main()
