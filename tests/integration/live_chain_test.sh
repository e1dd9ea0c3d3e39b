#!/bin/sh
# Simulator, tracker, scorer and lcm-logger as processes of their own over UDP multicast, in a network namespace of
# their own: as many TRACKS as scans (or images), none lost, and a replay that is equal. Usage: live_chain_test.sh
# LOOKOUT SCENARIO SPEED FLAGS, the flags of track and replay. Status 77 where this machine cannot run it.
set -u
lookout=$1 scenario=$2 speed=$3 flags=$4

if [ "${5:-}" != inside ]; then
  command -v lcm-logger > /dev/null || { echo "SKIPPED: lcm-logger (liblcm-bin) is not installed"; exit 77; }
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn sh -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@" inside' "$0" "$@"
fi

url='udpm://239.255.76.67:7667?ttl=0'
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder"/*.txt; exit 1; }

lcm-logger --quiet --lcm-url="$url" "$folder/log" > "$folder/logger.txt" 2>&1 &
logger=$!
"$lookout" score --lcm-url "$url" > "$folder/score.txt" 2>&1 &
scorer=$!
# The simulator starts when it hears the tracker: logger and scorer must be up before that.
for _ in $(seq 100); do
  grep -q 'lookout score' "$folder/log" 2> /dev/null && break
  sleep 0.2
done
"$lookout" track $flags --seed 1003 --lcm-url "$url" > "$folder/track.txt" 2>&1 &
tracker=$!
"$lookout" sim "$scenario" --seed 1003 --wait-for 1 --speed "$speed" --lcm-url "$url" --duration 120 \
  > "$folder/sim.txt" 2>&1 || fail "the simulator"
sleep 1
kill -TERM "$tracker" && wait "$tracker" || fail "the tracker did not stop with status 0"
kill -INT "$scorer" && wait "$scorer" || fail "the scorer did not stop with status 0"
kill -INT "$logger"
wait "$logger"

"$lookout" replay "$folder/log" $flags --seed 1003 --out "$folder/a" 2> "$folder/replay.txt" || fail "replay"
"$lookout" replay "$folder/log" $flags --seed 1003 --out "$folder/b" 2> /dev/null || fail "second replay"
sent=$(sed -n 's/.*sim: \([0-9]*\) scans sent.*/\1/p' "$folder/sim.txt")
grep -q " $sent TRACKS in the log, $sent now, equal" "$folder/replay.txt" || fail "$sent scans sent, not all tracked"
grep -q "over $sent scans" "$folder/score.txt" || fail "not all scans scored"
[ "$(wc -l < "$folder/a/tracks.csv")" -gt 10 ] || fail "no tracks"
cmp "$folder/a/tracks.csv" "$folder/b/tracks.csv" || fail "two replays differ"
cmp "$folder/a/tracks.csv" "$folder/a/logged_tracks.csv" || fail "the replay differs from the TRACKS in the log"
echo "passed: $sent scans, $sent TRACKS, replay equal"
