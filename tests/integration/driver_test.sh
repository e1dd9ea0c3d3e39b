#!/bin/sh
# The drivers of examples/ beside a tracker, over UDP multicast in a network namespace of their own: every ping of theirs
# is tracked. usage: driver_test.sh LOOKOUT PYTHON_FOLDER EXAMPLES GENERATED_HEADERS. Status 77 where this machine
# cannot run it.
set -u
lookout=$1 python=$2 examples=$3 headers=$4

if [ "${5:-}" != inside ]; then
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn sh -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@" inside' "$0" "$@"
fi

export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0' PYTHONPATH="$python"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder"/*.txt; exit 1; }

# tracked NAME PINGS FLAGS COMMAND...: a tracker with FLAGS takes the PINGS that COMMAND publishes.
tracked() {
  name=$1 pings=$2 flags=$3
  shift 3
  "$lookout" track $flags --duration 100 > "$folder/$name.txt" 2>&1 &
  tracker=$!
  for _ in $(seq 200); do
    grep -q 'track: ' "$folder/$name.txt" && break
    sleep 0.1
  done
  "$@" >> "$folder/$name.txt" 2>&1 || fail "$name"
  sleep 1
  kill -TERM "$tracker" && wait "$tracker" || fail "the tracker beside $name did not stop with status 0"
  grep -q " $pings scans tracked" "$folder/$name.txt" || fail "$name: not $pings pings tracked"
  echo "$name: $pings pings tracked"
}

c++ -std=c++17 -I"$headers" "$examples/driver.cpp" -llcm -o "$folder/driver" || fail "the driver in C++ does not compile"
tracked cpp 40 "--tracker gnn" "$folder/driver"
tracked python 40 "--tracker gnn" python3 "$examples/driver.py"
tracked images 20 "--estimator h_pmht" python3 "$examples/image_driver.py"
echo passed
