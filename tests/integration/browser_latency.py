"""What a tracker needs for a scan while two clients look on, one of them stalled, and while none does, in one run: the time
that passes and the tracker's own CPU time, which other programs on the machine do not lengthen by making it wait."""
import math
import select
import socket
import statistics
import struct
import time

# Short blocks, for a machine's load drifts. A stalled client costs most while its buffers fill: before it is cut off.
SETTLE_S, BLOCK_S = 0.1, 0.25
FEWEST_PAIRS, MOST_PAIRS = 40, 300
TOLD_EVERY = 100          # Pairs.
FEWEST_SCANS = 10         # Of a block that says something.
SMALL_MAGIC = 0x4C433032  # "LC02": a message of one datagram.
SO_TIMESTAMPNS = 35       # Linux's, as the next; names that Python does not have.
CPU_CLOCK_OF_PROCESS = 2  # CPUCLOCK_SCHED beside a process's number.
MAD_TO_SIGMA, MEDIAN_TO_MEAN = 1.4826, 1.2533  # Of a normal law: sigma over MAD; error of the median over the mean's.


class Listener:
    """Hears the datagrams of one multicast group with the times at which the kernel took them."""

    def __init__(self, group, port):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4_000_000)
        self.socket.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
        self.socket.bind((group, port))
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(group) + socket.inet_aton("0.0.0.0"))

    def latencies(self, seconds):
        """Milliseconds from each scan to its tracks, of the scans of the next so many seconds."""
        scans, found, end = {}, [], time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if not select.select([self.socket], [], [], left)[0]:
                continue
            data, controls, _, _ = self.socket.recvmsg(65536, 64)
            channel, utime = message_of(data)
            stamp = next((second + 1e-9 * nano for _, kind, content in controls if kind == SO_TIMESTAMPNS
                          for second, nano in [struct.unpack("qq", content)]), None)
            if stamp is None or utime is None:
                continue
            if channel == b"SONAR_SCAN":
                scans[utime] = stamp
            elif channel == b"TRACKS" and utime in scans:
                found.append(1e3 * (stamp - scans.pop(utime)))
        return found

    def forget(self):
        """Leaves out what has come meanwhile."""
        while select.select([self.socket], [], [], 0)[0]:
            self.socket.recv(65536)


def message_of(data):
    """Channel and utime, the first field behind the fingerprint; nothing of another datagram."""
    if len(data) < 8 or struct.unpack(">I", data[:4])[0] != SMALL_MAGIC:
        return None, None
    channel, _, content = data[8:].partition(b"\0")
    return channel, struct.unpack(">q", content[8:16])[0] if len(content) >= 16 else None


def ratio_and_error(ratios):
    """The median of log ratios and its standard error, by the median deviation: a machine's hiccups do not count."""
    median = statistics.median(ratios)
    deviation = statistics.median(abs(ratio - median) for ratio in ratios)
    return median, MEDIAN_TO_MEAN * MAD_TO_SIGMA * deviation / math.sqrt(len(ratios))


def cpu_ms(pid):
    """CPU time of a process so far, threads that have ended included: what clock_getcpuclockid(3) reads, to the nanosecond."""
    return 1e3 * time.clock_gettime(~pid << 3 | CPU_CLOCK_OF_PROCESS)


def block(listener, tracker, clients):
    """Median latency and CPU time a scan of one block, before what `clients()` opens. None where the machine kept all waiting."""
    opened = clients() if clients else []
    time.sleep(SETTLE_S)
    listener.forget()
    begin = cpu_ms(tracker)
    found = listener.latencies(BLOCK_S)
    used = cpu_ms(tracker) - begin
    for client in opened:
        client.close()
    return (statistics.median(found), used / len(found)) if len(found) >= FEWEST_SCANS else None


def compare(listener, tracker, clients, largest_error, most_pairs=MOST_PAIRS):
    """What scans cost with clients over what they cost without: (log ratio, standard error) of latency and of CPU time, and pairs.

    tracker is a process; clients() opens clients and returns them. Blocks come in turns (without, with, with, without),
    so that what drifts falls on both; pairs are taken until both errors are at most largest_error, most_pairs at most.
    """
    ratios, ends = [], ((0.0, math.inf), (0.0, math.inf))
    for pair in range(most_pairs):
        turns = (None, clients) if pair % 2 == 0 else (clients, None)
        costs = {turn is clients: block(listener, tracker, turn) for turn in turns}
        if None not in costs.values():
            ratios.append([math.log(a / b) for a, b in zip(costs[True], costs[False])])
        if len(ratios) >= FEWEST_PAIRS:
            ends = tuple(ratio_and_error(each) for each in zip(*ratios))
        if pair % TOLD_EVERY == TOLD_EVERY - 1:
            print(f"   after {len(ratios)} pairs standard errors of " + " and ".join(f"{error:.4f}" for _, error in ends), flush=True)
        if max(error for _, error in ends) <= largest_error:
            break
    return *ends, len(ratios)
