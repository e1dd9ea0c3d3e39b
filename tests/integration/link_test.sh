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
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; for file in "$folder"/*.txt; do echo "== $file"; cat "$file"; done; exit 1; }
said() { grep -q "$2" "$folder/$1.txt" || fail "$1 did not say: $2"; }
tracked() { sed -n 's/.*track: \([0-9]*\) scans tracked.*/\1/p' "$folder/track.txt"; }
up() { ip tuntap add dev sea0 mode tap && ip addr add 10.7.7.1/24 dev sea0 && ip link set sea0 up && ip route add 224.0.0.0/4 dev sea0; }
ip link set lo up
up 2> /dev/null || { echo "SKIPPED: no tap interface here"; exit 77; }
ip link del sea0

"$lookout" track --tracker gnn 2> "$folder/track.txt" &
tracker=$!
sleep 1
said track 'trying again until it can'
up
sleep 1.5
said track 'link: open'

"$lookout" sim "$scenario" --speed 8 --wait-for 1 --duration 60 2> "$folder/sim.txt" &
simulator=$!
sleep 2.5
ip link del sea0
sleep 6.5
said sim 'messages could not be sent: Network is unreachable'
said track 'no message for 5 s'
up
wait $simulator || fail "the simulator"
said sim 'messages, of scans, vehicle states and truth, could not be sent'
sleep 1
kill -TERM $tracker && wait $tracker || fail "the tracker did not stop with status 0"
said track 'sockets were made anew'
said track 'messages again after'
said track 'lost by sequence'
# 160 scans of which the 52 of 6.5 s were never sent, and those of at most 5 s behind them had no listener.
[ "$(tracked)" -ge 50 ] || fail "the tracker tracked $(tracked) scans"
"$lookout" track --lcm-url tcpq://127.0.0.1:9 --duration 5 2> "$folder/tcpq.txt"
[ $? -eq 1 ] || fail "a tcpq server that is not there is status 1"
echo "passed: $(tracked) scans tracked"
