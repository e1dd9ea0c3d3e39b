"""How long a tracker takes for a scan while a browser that is stalled looks on, and while none does, in one run."""
import math
import select
import socket
import statistics
import struct
import time

SETTLE_S, BLOCK_S = 0.4, 1.0
FEWEST_PAIRS, MOST_PAIRS = 12, 60
FEWEST_SCANS = 10         # Of a block that says something.
SMALL_MAGIC = 0x4C433032  # "LC02": a message of one datagram.
SO_TIMESTAMPNS = 35       # Linux's; a name that Python does not have.
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


def latency(listener, stall):
    """The median of one block; with `stall` before a stalled client. None where the machine kept everybody waiting."""
    client = stall() if stall else None
    time.sleep(SETTLE_S)
    listener.forget()
    found = listener.latencies(BLOCK_S)
    if client:
        client.close()
    return statistics.median(found) if len(found) >= FEWEST_SCANS else None


def compare(listener, stall, largest_error):
    """Latency with a stalled browser over that without: log ratio, standard error, pairs of blocks.

    stall() opens a stalled client and returns it. Blocks come in turns (without, with, with, without), so that what
    drifts falls on both; pairs are taken until the error is at most largest_error, MOST_PAIRS at most.
    """
    ratios = []
    for pair in range(MOST_PAIRS):
        turns = (None, stall) if pair % 2 == 0 else (stall, None)
        medians = {turn is stall: latency(listener, turn) for turn in turns}
        if None not in medians.values():
            ratios.append(math.log(medians[True] / medians[False]))
        if len(ratios) >= FEWEST_PAIRS and ratio_and_error(ratios)[1] <= largest_error:
            break
    return (*ratio_and_error(ratios), len(ratios)) if len(ratios) >= FEWEST_PAIRS else (0.0, math.inf, len(ratios))
