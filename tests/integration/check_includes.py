#!/usr/bin/python3
"""Checks that includes go one way: core <- csht <- tracking <- fusion; core <- sonar_sim; core <- lcmtypes.

Nodes may also include lcmtypes; tools, tests and python anything; LCM's own headers stand in lcmtypes and nodes alone.
The inner walls stand in INNER_WALLS: within each list a folder may include itself, what stands before it and
folders that the list does not name. Prints one line a breach and exits 1 where there is one.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ALLOWED = {
    "core": {"core"},
    "lcmtypes": {"core", "lcmtypes"},
    "sonar_sim": {"core", "sonar_sim"},
    "csht": {"core", "csht"},
    "tracking": {"core", "csht", "tracking"},
    "fusion": {"core", "csht", "tracking", "fusion"},
}
# Rooms of one house, each list from the first that may be included by all to the last that may include all.
INNER_WALLS = [
    ["csht/likelihood", "csht/likelihood/clutter", "csht/joint"],
    ["csht/joint/density", "csht/joint/evidence", "csht/joint"],
    ["tracking/initiation/plots", "tracking/initiation/lines", "tracking/initiation/methods"],
    ["tracking/detection", "tracking"],
    ["tools/cli", "tools/experiments/harness", "tools/experiments"],
]
CORE_HEADER_LIBRARIES = re.compile(r"^(Eigen/|[a-z_]+$)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def room_of(path, wall):
    """The number of the innermost room of a wall that holds the path; None outside."""
    rooms = [(len(room), number) for number, room in enumerate(wall) if path.startswith(room + "/")]
    return max(rooms)[1] if rooms else None


def inner_breaches(path):
    name = str(path.relative_to(ROOT))
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if not match or match.group(1) != '"':
            continue
        for wall in INNER_WALLS:
            own, other = room_of(name, wall), room_of(match.group(2), wall)
            if own is not None and other is not None and other > own:
                yield f"{name}:{number}: {wall[own]} may not include {match.group(2)}"


def breaches(path):
    folder = path.relative_to(ROOT).parts[0]
    is_node = "_node." in path.name
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, target = match.groups()
        first = target.split("/")[0]
        if bracket == '"' and first not in ALLOWED[folder] | ({"lcmtypes"} if is_node else set()):
            yield f"{path.relative_to(ROOT)}:{number}: {folder} may not include {target}"
        if first in ("lcm", "lookout") and "/" in target and not (folder == "lcmtypes" or is_node):
            yield f"{path.relative_to(ROOT)}:{number}: LCM headers belong to lcmtypes and *_node files"
        if folder == "core" and path.suffix == ".hpp" and bracket == "<" and not CORE_HEADER_LIBRARIES.match(target):
            yield f"{path.relative_to(ROOT)}:{number}: a core header needs Eigen alone, not {target}"


def main():
    found = [
        breach
        for folder in ALLOWED
        for path in sorted((ROOT / folder).rglob("*.[ch]pp"))
        for breach in breaches(path)
    ]
    found += [
        breach
        for folder in [*ALLOWED, "tools"]
        for path in sorted((ROOT / folder).rglob("*.[ch]pp"))
        for breach in inner_breaches(path)
    ]
    print("\n".join(found) or "include direction: no breach")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
