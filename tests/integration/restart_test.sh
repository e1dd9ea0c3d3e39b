#!/bin/sh
# A tracker that is stopped in the middle of a scene and started again: it stops with status 0 at once, and the new one
# tracks what comes then. usage: restart_test.sh LOOKOUT SCENARIO. Status 77 where this machine cannot run it.
set -u
lookout=$1 scenario=$2

if [ "${3:-}" != inside ]; then
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn sh -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@" inside' "$0" "$@"
fi

export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0'
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder"/*.txt; exit 1; }
# Scans tracked, as the tracker says at its end.
tracked() { sed -n 's/.*track: \([0-9]*\) scans tracked.*/\1/p' "$1"; }

"$lookout" track --tracker gnn 2> "$folder/first.txt" &
first=$!
"$lookout" sim "$scenario" --speed 10 --wait-for 1 --duration 60 2> "$folder/sim.txt" &
simulator=$!
sleep 2
kill -TERM $first && wait $first || fail "the first tracker did not stop with status 0"
"$lookout" track --tracker gnn 2> "$folder/second.txt" &
second=$!
wait $simulator || fail "the simulator"
sleep 1
kill -TERM $second && wait $second || fail "the second tracker did not stop with status 0"
[ "$(tracked "$folder/first.txt")" -ge 10 ] || fail "the first tracker tracked too little"
[ "$(tracked "$folder/second.txt")" -ge 10 ] || fail "the second tracker tracked too little"
echo "passed: $(tracked "$folder/first.txt") scans before the restart, $(tracked "$folder/second.txt") after"
