"""The one file of a bag, as bytes."""

import tempfile
from pathlib import Path

from vrts.report.assessment import Assessment
from vrts.report.ros.bag import write_bag


def mcap_bytes(a: Assessment) -> bytes:
    """Return a run as an MCAP file.

    Raises:
        ValueError: There is no run.
    """
    with tempfile.TemporaryDirectory() as folder:  # rosbags writes folders only
        return write_bag(a, Path(folder) / "run").read_bytes()
