#!/usr/bin/env bash
# tools/cluster on four hosts, network namespaces with an sshd each, two of which die on the way: the result is complete
# and equal to one machine's. Then its master is killed and --resume goes on.
# usage: cluster_test.sh LOOKOUT SOURCE_DIR
set -euo pipefail
lookout=$(realpath "$1") source=$(realpath "$2")
. "$source/tests/integration/namespaces.sh"
sshd=$(PATH=$PATH:/usr/sbin command -v sshd) || skip "sshd is missing (tools/setup --with-cluster installs it)"
command -v parallel > /dev/null || skip "GNU parallel is missing (tools/setup --with-cluster installs it)"
[ -n "${ENTERED:-}" ] || enter_namespaces "$0" "$@"

work=$(mktemp -d)
finish() {
  local k
  for k in 1 2 3 4; do kill_host host "$k" 2> /dev/null || true; done
  rm -rf "$work"
}
trap finish EXIT
make_hosts host 4
mkdir -p "$work/bin" "$work/slow" "$work/home" /run/sshd
ln -s "$lookout" "$work/bin/lookout"
# Of host 2, whose shards never end: it is at work when it is killed, however fast the machine is.
cat > "$work/slow/lookout" <<END
#!/bin/sh
case "\$*" in *--shard*) sleep 600 ;; esac
exec "$lookout" "\$@"
END
chmod +x "$work/slow/lookout"
ssh-keygen -q -t ed25519 -N "" -f "$work/key"
ssh-keygen -q -t ed25519 -N "" -f "$work/host_key"
configure() { cat <<END
HostKey $work/host_key
AuthorizedKeysFile $work/key.pub
PermitRootLogin yes
StrictModes no
UsePAM no
PidFile none
SetEnv PATH=$1:/usr/bin:/bin HOME=$work/home LOOKOUT_TOOLS=$source/tools
END
}
for k in 1 2 3 4; do
  configure "$work/$([ "$k" = 2 ] && echo slow || echo bin)" > "$work/sshd_config$k"
  ip netns exec "host$k" "$sshd" -f "$work/sshd_config$k"
  echo "1/10.99.0.$k  # host$k"
done > "$work/hosts"
export LOOKOUT_SSH="ssh -i $work/key -o BatchMode=yes -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null \
-o LogLevel=ERROR -o ConnectTimeout=2 -o ServerAliveInterval=1 -o ServerAliveCountMax=2"
export PATH="$work/bin:$PATH" LOOKOUT_TOOLS="$source/tools" HOME="$work/home"
for k in 1 2 3 4; do wait_until $LOOKOUT_SSH "10.99.0.$k" true 2> /dev/null; done

mkdir "$work/study" && cd "$work/study"
sed 's/^duration: .*/duration: 30.0/' "$source/tools/scenarios/crossing.yaml" > scene.yaml  # Half of it, with which a shard still takes a while.
command=(lookout compare scene.yaml --method joint --method gnn --runs 6 --seed 1000 --jobs 1)
"${command[@]}" --out alone 2> /dev/null

# A host dies amid a shard, and another that is idle then.
"$source/tools/cluster" --shards 12 "$work/hosts" -- "${command[@]}" --out spread 2> "$work/log" &
master=$!
wait_until works_on_shard host 2
kill_host host 2
wait "$master" || { cat "$work/log"; exit 1; }
same_comparison alone spread
grep -q "0 of 12 shards are there, 4 hosts" "$work/log"
grep -q "12 of 12 shards are finished" "$work/log"
echo "one of four hosts killed: complete and equal"

# The master dies; --resume goes on with the three hosts that are left.
"$source/tools/cluster" --shards 12 "$work/hosts" -- "${command[@]}" --out again 2> "$work/log" &
master=$!
one_is_there() { [ -n "$(find again/shards -mindepth 1 -maxdepth 1 -type d -name '[0-9]*' 2> /dev/null)" ]; }
wait_until one_is_there
kill -TERM "$master"
wait "$master" || true
grep -q "10.99.0.2 does not answer" "$work/log"
if "$source/tools/cluster" --shards 12 "$work/hosts" -- "${command[@]}" --out again 2> "$work/refusal"; then
  echo "shards of an earlier call were overwritten"; exit 1
fi
grep -q -- "--resume goes on" "$work/refusal"
"$source/tools/cluster" --shards 12 --resume "$work/hosts" -- "${command[@]}" --out again 2> "$work/log" ||
  { cat "$work/log"; exit 1; }
grep -q "^cluster: [1-9][0-9]* of 12 shards are there, 3 hosts" "$work/log" || { cat "$work/log"; exit 1; }
same_comparison alone again
echo "master killed and resumed: complete and equal"
