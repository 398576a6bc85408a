"""A run as messages of ROS 2 in a file."""

from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import WRONG, fail, say, warn, write_file

if TYPE_CHECKING:
    from vrts.report.assessment import Assessment

NOT_INSTALLED = "messages of ROS need a package that is installed by: pip install 'vrts[ros]'"


def write_mcap(found: "Assessment", path: Path) -> None:
    """Write a run as an MCAP file and say so."""
    if found.run is None:
        warn("nothing ran, so there is nothing to write")
        return
    try:
        from vrts.report.ros.file import mcap_bytes
    except ModuleNotFoundError:
        fail(NOT_INSTALLED, status=WRONG)
    write_file(path, mcap_bytes(found))
    say(f"wrote {path}")
