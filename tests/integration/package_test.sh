#!/bin/sh
# Installs the build into a temporary folder and builds, links and runs a program on find_package(lookout).
# usage: package_test.sh BUILD_DIR PACKAGE_SOURCE_DIR
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/installed" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
cmake -S "$2" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
cmake --build "$folder/build" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
"$folder/build/consumer"
test -f "$folder/installed/share/lookout/tools/scenarios/tracking_table7.yaml"
