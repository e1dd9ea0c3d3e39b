#!/bin/sh
# Five processes over UDP multicast in a network namespace of their own: one simulator of two vehicles, a tracker for
# each, fusion and a scorer of the global tracks. The second tracker is killed and started again in mid-run. Each link
# stays within 256 bytes in any second. Usage: two_uuv_test.sh LOOKOUT SCENARIO SPEED. Status 77 where this machine
# cannot run it.
set -u
lookout=$1 scenario=$2 speed=$3

if [ "${4:-}" != inside ]; then
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn sh -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@" inside' "$0" "$@"
fi

url='udpm://239.255.76.67:7667?ttl=0'
folder=$(mktemp -d)
trap 'kill $(jobs -p) 2> /dev/null; rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder"/*.txt; exit 1; }
track() { # PREFIX NODE FILE
  exec "$lookout" track --tracker gnn --seed 1003 --publish-estimates --channel-prefix "$1" --node-id "$2" \
    --lcm-url "$url" > "$folder/$3" 2>&1
}

"$lookout" fuse --lcm-url "$url" > "$folder/fuse.txt" 2>&1 &
fuse=$!
"$lookout" score --tracks GLOBAL_TRACKS --channel-prefix AUV1_ --truth schedule --lcm-url "$url" > "$folder/score.txt" 2>&1 &
score=$!
track AUV1_ 1 track_1.txt &
first=$!
track AUV2_ 2 track_2.txt &
second=$!
"$lookout" sim "$scenario" --seed 1003 --wait-for 2 --speed "$speed" --lcm-url "$url" --duration 120 \
  > "$folder/sim.txt" 2>&1 &
sim=$!
sleep 5
kill -KILL "$second"
wait "$second" 2> /dev/null
track AUV2_ 2 track_3.txt &
third=$!
wait "$sim" || fail "the simulator"
sleep 1
for process in "$first" "$third" "$fuse" "$score"; do
  kill -TERM "$process" && wait "$process" || fail "a process did not stop with status 0"
done

pictures=$(sed -n 's/.*fuse: \([0-9]*\) pictures.*/\1/p' "$folder/fuse.txt")
[ "${pictures:-0}" -ge 50 ] || fail "only ${pictures:-no} pictures"
for link in track_1 track_3; do
  most=$(sed -n 's/.*at most \([0-9]*\) in any second.*/\1/p' "$folder/$link.txt")
  [ "${most:-999}" -gt 0 ] && [ "${most:-999}" -le 256 ] || fail "$link sent ${most:-nothing} bytes in a second"
done
grep -q " over [1-9][0-9]* scans" "$folder/score.txt" || fail "no global picture was scored"
echo "passed: $pictures pictures; $(grep -h 'OSPA\|over' "$folder/score.txt" | tail -1)"
