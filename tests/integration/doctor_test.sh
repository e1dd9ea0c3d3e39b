#!/bin/sh
# `lookout doctor` in a network of its own: it finds a missing route, a small buffer and a ttl that reaches nobody, and
# what it says to type cures each. usage: doctor_test.sh LOOKOUT. Status 77 where this machine cannot run it.
set -u
lookout=$1

if [ "${2:-}" != inside ]; then
  unshare -rn true 2> /dev/null || { echo "SKIPPED: no private network namespace (unshare -rn) here"; exit 77; }
  exec unshare -rn "$0" "$@" inside
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
base='udpm://239.255.76.67:7667?ttl='
fail() { echo "FAILED: $*"; cat "$folder/said"; exit 1; }
examine() { # examine STATUS URL: runs the doctor, who must end with this status.
  "$lookout" doctor --lcm-url "$2" --out "$folder" > "$folder/said" 2> "$folder/errors"
  [ $? -eq "$1" ] || fail "the doctor did not end with status $1 on $2"
}
found() { grep -q "$1" "$folder/said" || fail "not found: $1"; }
cure_of() { sed -n "/^FAILURE $1/{n;s/^ *-> //p}" "$folder/said"; } # cure_of NAME: what it says to type.

examine 1 "${base}0"
found 'FAILURE route: none'
cure=$(cure_of route)
sh -c "${cure%% (this computer alone)*}" || fail "what it says cannot be typed: $cure"
examine 0 "${base}0"
found 'ok      route: 239.255.76.67 by lo'
found 'link: small 10/10, large 2/2'

examine 1 "${base}0&recv_buf_size=4096"
found 'FAILURE socket buffer'
found 'leave recv_buf_size out of the URL'
size=$(cure_of 'socket buffer' | sed 's/.* or set it to //')
examine 0 "${base}0"
examine 0 "${base}0&recv_buf_size=${size:?no size named}"

examine 1 "${base}1"
found 'FAILURE ttl: ttl=1, but multicast goes to the loopback'
url=$(cure_of ttl | sed "s/^--lcm-url '\([^']*\)' (this computer alone).*/\1/")
examine 0 "${url:?no URL named}"
"$lookout" doctor --lcm-url "${base}0" --out "$folder/absent" > "$folder/said" && fail "an absent directory is no failure"
found 'FAILURE output'
echo "passed"
