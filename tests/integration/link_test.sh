#!/bin/sh
# The link as it fails at sea: a tracker that starts before its network, a route that goes away while it runs, an interface
# that is removed and made again. usage: link_test.sh LOOKOUT SCENARIO. Status 77 where this machine cannot run it.
set -u
lookout=$1 scenario=$2

if [ "${3:-}" != inside ]; then
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn "$0" "$@" inside
fi

export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0'
folder=$(mktemp -d)
tracker= simulator=
trap 'kill $tracker $simulator 2> /dev/null; rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; for file in "$folder"/*.txt; do echo "== $file"; cat "$file"; done; exit 1; }
said() { grep -q "$2" "$folder/$1.txt" || fail "$1 did not say: $2"; }
tracked() { sed -n 's/.*track: \([0-9]*\) scans tracked.*/\1/p' "$folder/track.txt"; }
up() { ip tuntap add dev sea0 mode tap && ip addr add 10.7.7.1/24 dev sea0 && ip link set sea0 up && ip route add 224.0.0.0/4 dev sea0; }
heard() { # Waits at most 30 s until a node says so.
  for _ in $(seq 300); do grep -q "$2" "$folder/$1.txt" && return; sleep 0.1; done
  fail "$1 did not say: $2"
}
ip link set lo up
up 2> /dev/null || { echo "SKIPPED: no tap interface here"; exit 77; }
ip link del sea0

"$lookout" track --tracker gnn 2> "$folder/track.txt" &
tracker=$!
heard track 'trying again until it can'
up
heard track 'link: open'

# 200 scans in 50 s of wall time.
"$lookout" sim "$scenario" --speed 2 --wait-for 1 2> "$folder/sim.txt" &
simulator=$!
heard track 'tracker gnn'
sleep 2
ip link del sea0
heard sim 'messages could not be sent: Network is unreachable'
heard track 'no message for 5 s'
up
heard track 'messages again after'
sleep 2
kill -TERM $simulator && wait $simulator || fail "the simulator did not stop with status 0"
said sim 'messages, of scans, vehicle states and truth, could not be sent'
kill -TERM $tracker && wait $tracker || fail "the tracker did not stop with status 0"
# Linux hands multicast to every socket of the group once one of them joined anew, so either node's is enough.
grep -q 'sockets were made anew' "$folder/sim.txt" "$folder/track.txt" || fail "no node made its sockets anew"
# The gap is lost scans or, where it was long, a new clock.
grep -q 'lost by sequence\|new clock' "$folder/track.txt" || fail "the gap was not told"
[ "$(tracked)" -ge 1 ] || fail "the tracker tracked $(tracked) scans"
"$lookout" track --lcm-url tcpq://127.0.0.1:9 --duration 5 2> "$folder/tcpq.txt"
[ $? -eq 1 ] || fail "a tcpq server that is not there is status 1"
echo "passed: $(tracked) scans tracked"
