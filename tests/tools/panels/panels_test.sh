#!/bin/sh
# Opens every lcm-spy panel under a virtual display and looks at its pixels. usage: panels_test.sh BUILD_DIR TEST.java
# Status 77 where this machine has not the tools.
set -eu
for tool in javac java Xvfb; do
  command -v $tool > /dev/null || { echo "SKIPPED: $tool is not installed (tools/spy brings Java; tools/setup xvfb)"; exit 77; }
done
folder=$(mktemp -d)
jars=/usr/share/java/lcm.jar:$1/lookout_types.jar:$1/lookout_spy.jar
# Xvfb finds a free display by itself and writes its number once it serves it.
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp 3> "$folder/display" 2> "$folder/xvfb.txt" &
server=$!
trap 'kill $server 2> /dev/null; rm -rf "$folder"' EXIT
for _ in $(seq 100); do
  [ -s "$folder/display" ] && break
  sleep 0.1
done
[ -s "$folder/display" ] || { cat "$folder/xvfb.txt"; echo "SKIPPED: Xvfb does not start here"; exit 77; }
javac --release 17 -cp "$jars" -d "$folder" "$2"
DISPLAY=:$(cat "$folder/display") LCM_DEFAULT_URL=memq:// \
  timeout 60 java -Djava.awt.headless=false -cp "$jars:$folder" lookout.panels.PanelTest ${3:+"$3"}
