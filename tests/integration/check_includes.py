#!/usr/bin/python3
"""Checks that includes go one way: core <- csht <- tracking <- fusion; core <- sonar_sim; core <- lcmtypes.

Nodes may also include lcmtypes; tools and tests anything; LCM's own headers stand in lcmtypes and nodes alone.
Prints one line a breach and exits 1 where there is one.
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
CORE_HEADER_LIBRARIES = re.compile(r"^(Eigen/|[a-z_]+$)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


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
    print("\n".join(found) or "include direction: no breach")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
