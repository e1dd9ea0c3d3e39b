#!/usr/bin/env bash
# tools/slurm_array on three nodes, network namespaces with a slurmd each, one of which is cut off on the way: the result
# is complete and equal to one machine's.
# usage: slurm_test.sh LOOKOUT SOURCE_DIR
set -euo pipefail
lookout=$(realpath "$1") source=$(realpath "$2")
. "$source/tests/integration/namespaces.sh"
export PATH=$PATH:/usr/sbin:/sbin
for program in slurmctld slurmd sbatch munged; do
  command -v $program > /dev/null || skip "$program is missing (tools/setup --with-cluster installs Slurm)"
done
[ -n "${ENTERED:-}" ] || enter_namespaces "$0" "$@"

work=$(mktemp -d)
chmod 755 "$work"
services=()
finish() {
  local k
  for k in 1 2 3; do kill_host node "$k" 2> /dev/null || true; done
  [ ${#services[@]} -eq 0 ] || kill "${services[@]}" 2> /dev/null || true
  wait 2> /dev/null || true
  umount /sys/fs/cgroup 2> /dev/null || true
  rm -rf "$work"
}
trap finish EXIT
make_hosts node 3
mount -t tmpfs none /sys/fs/cgroup  # in this mount namespace alone: slurmd wants to make folders there
mkdir -p "$work/bin" "$work/state" "$work/spool" "$work/munge"
ln -s "$lookout" "$work/bin/lookout"
export PATH="$work/bin:$PATH" LOOKOUT_TOOLS="$source/tools" SLURM_CONF="$work/slurm.conf"

dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 2> /dev/null
chmod 400 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
  --log-file="$work/munge/log" --seed-file="$work/munge/seed" > /dev/null 2>&1 &
services+=($!)
wait_until test -S "$work/munge/socket"

cat > "$work/slurm.conf" <<END
ClusterName=namespaces
SlurmctldHost=$(hostname -s)(10.99.0.254)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CryptoType=crypto/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool/%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/linear
SchedulerParameters=sched_interval=1,batch_sched_delay=0
SlurmctldTimeout=5
SlurmdTimeout=5
KillWait=1
MinJobAge=30
JobRequeue=1
ReturnToService=2
MpiDefault=none
$(for k in 1 2 3; do echo "NodeName=node$k NodeAddr=10.99.0.$k CPUs=1 RealMemory=100 State=UNKNOWN"; done)
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
echo "CgroupPlugin=cgroup/v1" > "$work/cgroup.conf"
slurmctld -D -f "$work/slurm.conf" > /dev/null 2>&1 &
services+=($!)
for k in 1 2 3; do
  ip netns exec "node$k" slurmd -D -N "node$k" -f "$work/slurm.conf" > /dev/null 2>&1 &
  services+=($!)
done
all_idle() { [ "$(sinfo -h -o %T -N 2> /dev/null | grep -c '^idle$')" = 3 ]; }
wait_until all_idle || { tail "$work"/slurm*.log; skip "Slurm does not start on this machine"; }

mkdir "$work/study" && cd "$work/study"
cp "$source/tools/scenarios/crossing.yaml" scene.yaml
command=(lookout compare scene.yaml --method joint --method gnn --runs 6 --seed 1000 --jobs 1)
"${command[@]}" --out alone 2> /dev/null
"$source/tools/slurm_array" --shards 12 -- "${command[@]}" --out spread > "$work/log" 2>&1 &
master=$!
wait_until works_on_shard node 2
kill_host node 2
wait "$master" || { cat "$work/log"; tail "$work/slurmctld.log"; cat spread/shards/*.log; exit 1; }
same_comparison alone spread
grep -q "Killing job\|requeue\|not responding" "$work/slurmctld.log" || { echo "Slurm did not notice the cut"; exit 1; }
echo "one of three nodes cut off: complete and equal"
