"""Lookout in Python: simulate a scene, track it scan by scan, score it; read and write recordings and LCM logs.

    import lookout
    recording = lookout.simulate(lookout.Scene("tools/scenarios/crossing.yaml"), seed=1)
    run = lookout.track(recording, tracker="gnn")
    print(lookout.score(recording.truth, run.tracks, recording.times).total)

Units are metres, radians and seconds, the earth frame is north and east; utime is scenario time in whole microseconds.
Lists are numpy tables, one row an entry, whose fields have the names of the LCM messages: TRACK_DTYPE, ELEMENT_DTYPE,
TRUTH_DTYPE, STATE_DTYPE. Bad input is a ValueError with the one line of the command line, what is worth telling a
UserWarning. Long calls let other threads run. The messages' types (track_t, sonar_scan_t, ...) are here as well.
The guide is docs/python.md.
"""
from . import _messages
from ._messages import *  # noqa: F401, F403

# Of the compiled module, which is loaded when the first of them is asked for: a driver needs the messages' types alone, in
# whatever Python it runs, and no numpy.
_COMPILED = """
ELEMENT_DTYPE STATE_DTYPE TRACK_DTYPE TRUTH_DTYPE Chain Estimator GospaResult Image Log OspaResult Recording Result
Scan Scene Score Sensor SimulatedScan Simulator TargetQuality TrackedRun Tracker TrackQuality __version__
estimator_names gospa load_plugin ospa read_log read_recording read_tracks read_truth score simulate track track_quality
tracker_names write_log write_recording write_tracks write_truth
""".split()

__all__ = [*_COMPILED, *(name for name in vars(_messages) if name.endswith("_t"))]  # noqa: PLE0604


def __getattr__(name):
    if name not in _COMPILED:
        raise AttributeError(f"module 'lookout' has no attribute {name!r}")
    from . import _lookout

    globals().update({each: getattr(_lookout, each) for each in _COMPILED})
    return globals()[name]


def __dir__():
    return sorted(__all__)
