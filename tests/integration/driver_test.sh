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

export PYTHONPATH="$python"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder/$1".txt 2> /dev/null; exit 1; }

# tracked NAME PORT PINGS FLAGS COMMAND...: on a port of its own a tracker with FLAGS takes the PINGS that COMMAND publishes.
tracked() {
  name=$1 pings=$3 flags=$4
  export LCM_DEFAULT_URL="udpm://239.255.76.67:$2?ttl=0"
  shift 4
  "$lookout" track $flags --duration 100 > "$folder/$name.txt" 2>&1 &
  tracker=$!
  for _ in $(seq 200); do
    grep -q 'track: ' "$folder/$name.txt" && break
    sleep 0.1
  done
  "$@" >> "$folder/$name.txt" 2>&1 || fail "$name" did not publish
  sleep 1
  kill -TERM "$tracker" && wait "$tracker" || fail "$name" "the tracker beside it did not stop with status 0"
  grep -q " $pings scans tracked" "$folder/$name.txt" || fail "$name" "not $pings pings tracked"
  echo "$name: $pings pings tracked"
}

# All at once, for they publish as slowly as a sonar does. Each ends by itself, so that a failure leaves nothing behind.
(tracked python 7668 40 "--tracker gnn" python3 "$examples/driver.py") &
python_driver=$!
(tracked images 7669 20 "--estimator h_pmht" python3 "$examples/image_driver.py") &
image_driver=$!
c++ -std=c++17 -I"$headers" "$examples/driver.cpp" -llcm -o "$folder/driver" || fail "the driver in C++ does not compile"
(tracked cpp 7667 40 "--tracker gnn" "$folder/driver") &
cpp_driver=$!
status=0
for driver in $python_driver $image_driver $cpp_driver; do wait $driver || status=1; done
[ $status -eq 0 ] && echo passed
exit $status
