# Hosts for tests of more than one machine: network namespaces on a bridge, all inside a private network and mount
# namespace, so that nothing of the machine's own network is touched and nothing stays. To be sourced.

skip() { echo "skipped: $1"; exit 77; }

# Starts the calling script again in namespaces of its own. ENTERED tells it that it is inside.
enter_namespaces() { # SCRIPT ARGUMENTS...
  [ "$(id -u)" = 0 ] || skip "network namespaces with sshd in them need root"
  command -v ip > /dev/null || skip "ip is missing (package iproute2)"
  unshare -nm true 2> /dev/null || skip "this machine allows no namespaces"
  ENTERED=1 exec unshare -nm --propagation private "$@"
}

# A hub, this namespace, at 10.99.0.254 and hosts NAME1 to NAMEn at 10.99.0.1 to n.
make_hosts() { # NAME COUNT
  ip link set lo up
  mkdir -p /run/netns
  mount -t tmpfs none /run/netns
  ip link add hub type bridge
  ip link set hub up
  ip address add 10.99.0.254/24 dev hub
  local k
  for k in $(seq 1 "$2"); do
    ip netns add "$1$k"
    ip link add "v$k" type veth peer name eth0 netns "$1$k"
    ip link set "v$k" master hub up
    ip -n "$1$k" link set lo up
    ip -n "$1$k" address add "10.99.0.$k/24" dev eth0
    ip -n "$1$k" link set eth0 up
  done
}

# Cuts a host off and stops all that runs on it.
kill_host() { # NAME NUMBER
  ip link set "v$2" down
  local pids
  pids=$(ip netns pids "$1$2")
  [ -z "$pids" ] || kill -9 $pids 2> /dev/null || true
}

# Waits until a command succeeds, for two minutes at most.
wait_until() { # COMMAND...
  local tries=0
  until "$@"; do
    tries=$((tries + 1))
    [ "$tries" -lt 2400 ] || { echo "waited in vain for: $*" >&2; return 1; }
    sleep 0.05
  done
}

# Whether a host works on a shard.
works_on_shard() { # NAME NUMBER
  local pid
  for pid in $(ip netns pids "$1$2"); do
    [ "$(cat "/proc/$pid/comm" 2> /dev/null)" != lookout ] || ! grep -qas -- --shard "/proc/$pid/cmdline" || return 0
  done
  return 1
}

# The files of a comparison that must not differ by a byte.
same_comparison() { # ONE OTHER
  local file
  for file in curves.csv means.csv results.json table.tex report.html; do
    cmp "$1/$file" "$2/$file" || return 1
  done
}
