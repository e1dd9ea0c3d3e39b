#!/bin/sh
# The package under a real systemd, in a container without a network: its unit starts and waits, is healthy once there is a
# network and scans, is killed by the watchdog when it hangs, comes back after each of seven SIGKILLs with its identities,
# and stops with status 0. Needs root, systemd-nspawn and a Debian root with systemd and what the package depends on:
#   mmdebstrap --variant=minbase --include=systemd,systemd-sysv,dbus,iproute2,lookout's-dependencies bookworm ROOT
# usage: LOOKOUT_SYSTEMD_ROOT=ROOT systemd_test.sh BUILD_DIR SCENE. Status 77 where this machine cannot run it.
set -eu
root=${LOOKOUT_SYSTEMD_ROOT:-}
[ "$(id -u)" = 0 ] && command -v systemd-nspawn > /dev/null && [ -d "$root" ] ||
  { echo "SKIPPED: needs root, systemd-nspawn, and LOOKOUT_SYSTEMD_ROOT with a Debian root"; exit 77; }
folder=$(mktemp -d)
nspawn=''
cleanup() {
  [ -z "$nspawn" ] || kill -KILL "$nspawn" 2> /dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT
fail() { echo "FAILED: $*"; inside journalctl -u lookout-track --no-pager -n 20 || true; exit 1; }

# Runs a command among the container's processes.
inside() { nsenter --target "$init" --mount --uts --ipc --net --pid --root --wd -- "$@"; }
shown() { inside systemctl show --property "$1" --value lookout-track; }
# Waits until COMMAND... succeeds, at most two minutes.
await() {
  what=$1
  shift
  for _ in $(seq 240); do
    "$@" > /dev/null 2>&1 && return 0
    sleep 0.5
  done
  fail "$what"
}
is() { [ "$(shown "$1")" = "$2" ]; }
says() { inside journalctl -u lookout-track --no-pager -o cat | grep -q "$1"; }

(cd "$1" && cpack -D CPACK_COMPONENTS_ALL=vehicle -B "$folder" > "$folder/log" 2>&1) || { cat "$folder/log"; exit 1; }
cp "$folder"/lookout_*.deb "$root/root/lookout.deb"
cp "$2" "$root/root/scene.yaml"
chroot "$root" dpkg -i /root/lookout.deb > /dev/null
chroot "$root" systemctl enable lookout-track 2> /dev/null
rm -rf "$root/var/lib/private/lookout"
mkdir -p "$root/etc/systemd/system/lookout-track.service.d"
printf '[Service]\nWatchdogSec=5\n' > "$root/etc/systemd/system/lookout-track.service.d/short.conf"
systemd-nspawn -q -D "$root" -b --console=pipe --register=no --keep-unit --private-network < /dev/null > "$folder/boot" 2>&1 &
nspawn=$!
init=''
for _ in $(seq 100); do
  init=$(pgrep -P "$nspawn" | head -1)
  [ -z "$init" ] || break
  sleep 0.1
done
[ -n "$init" ] || { cat "$folder/boot"; echo "FAILED: no container"; exit 1; }

await "did not start without a network" is ActiveState active
await "does not say that it waits" says "trying again until it can"
inside sh -c 'ip link add eth0 type veth peer name eth9; ip addr add 192.168.7.2/24 dev eth0; ip link set eth9 up
              ip link set eth0 up; ip route add default dev eth0'
await "does not open the link" says "link: open"
inside lookout sim /root/scene.yaml --speed 5 > /dev/null 2>&1
await "is not healthy on scans from this computer" says "tracker joint"
is StatusText healthy || fail "says: $(shown StatusText)"
inside sh -c 'kill -STOP $(systemctl show --property MainPID --value lookout-track)'
await "the watchdog does not bite" is NRestarts 1
says "goes on where" || await "does not go on" says "goes on where"
for restarts in 2 3 4 5 6 7 8; do
  inside sh -c 'kill -KILL $(systemctl show --property MainPID --value lookout-track)'
  await "was given up after $restarts ends" is NRestarts "$restarts"
  await "is not up again" is ActiveState active
done
inside systemctl stop lookout-track
is ExecMainStatus 0 || fail "a stop is status $(shown ExecMainStatus)"
inside systemctl --no-block poweroff || true
echo "passed"
