"""Publishes messages over LCM's UDP multicast and writes and reads LCM logs, in plain Python: Debian has no lcm module.

    from lookout import sonar_scan_t
    from lookout_link import Link
    Link().publish("SONAR_SCAN", sonar_scan_t())
"""
import os
import socket
import struct
import urllib.parse

DEFAULT_URL = "udpm://239.255.76.67:7667?ttl=0"
SMALL_MAGIC, LARGE_MAGIC = 0x4C433032, 0x4C433033  # "LC02" and "LC03"
LARGEST_SMALL = 65499  # Bytes of channel, its zero and data in one datagram.
LARGEST_PART = 65487  # The same in one of several.
EVENT_MARK = 0xEDA1DA01  # Of an event in a log.


class Link:
    """One sender on UDP multicast.

    url: udpm://ADDRESS:PORT?ttl=N; by default LCM_DEFAULT_URL, else LCM's own address on this computer alone.
    """

    def __init__(self, url=None):
        parts = urllib.parse.urlsplit(url or os.environ.get("LCM_DEFAULT_URL") or DEFAULT_URL)
        if parts.scheme != "udpm":
            raise ValueError(f"{parts.geturl()}: expected udpm://ADDRESS:PORT?ttl=N")
        self._to = (parts.hostname or "239.255.76.67", parts.port or 7667)
        ttl = int(urllib.parse.parse_qs(parts.query).get("ttl", ["0"])[0])
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
        self._sequence = 0

    def publish(self, channel, message):
        """Sends one message; one that does not fit a datagram in several. OSError where the system refuses."""
        for datagram in datagrams(channel, message.encode(), self._sequence):
            self._socket.sendto(datagram, self._to)
        self._sequence = (self._sequence + 1) & 0xFFFFFFFF


def datagrams(channel, data, sequence):
    """The datagrams of a message as LCM 1.3 forms them."""
    name = channel.encode("ascii") + b"\0"
    if len(name) + len(data) <= LARGEST_SMALL:
        return [struct.pack(">II", SMALL_MAGIC, sequence) + name + data]
    ends = list(range(LARGEST_PART - len(name), len(data), LARGEST_PART)) + [len(data)]
    parts, begin = [], 0
    for number, end in enumerate(ends):
        header = struct.pack(">IIIIHH", LARGE_MAGIC, sequence, len(data), begin, number, len(ends))
        parts.append(header + (name if number == 0 else b"") + data[begin:end])
        begin = end
    return parts


def log_event(number, utime, channel, message):
    """The bytes of one message in an LCM log; utime in microseconds."""
    name, data = channel.encode("ascii"), message.encode()
    return struct.pack(">IqqII", EVENT_MARK, number, utime, len(name), len(data)) + name + data


def read_log(path):
    """(channel, bytes) of each message of an undamaged LCM log."""
    with open(path, "rb") as log:
        while header := log.read(28):
            mark, _, _, name_size, data_size = struct.unpack(">IqqII", header)
            if mark != EVENT_MARK:
                raise ValueError(f"{path}: is damaged, or no LCM log")
            name = log.read(name_size).decode("ascii")
            yield name, log.read(data_size)
