"""Where things stand in a recording, and texts that mean nothing but themselves."""

import numpy as np
import numpy.typing as npt
import rerun as rr

Array = npt.NDArray[np.float64]

TIMELINE = "t"  # [s] of the run
MARKDOWN = frozenset("\\`*_[]<>#!|~&{}")


def entity(name: str) -> str:
    """Return any name as one part of a path."""
    return rr.escape_entity_path_part(name.replace(" ", "_"))


def of_robot(name: str) -> str:
    """Return the path of a link, or of the hand."""
    return f"world/robot/{entity(name)}"


def of_finger(name: str) -> str:
    """Return the path of a finger, which goes with the hand."""
    return f"{of_robot('hand')}/{entity(name)}"


def of_body(name: str) -> str:
    """Return the path of a body of the scene."""
    return f"world/bodies/{entity(name)}"


def at_times(times: Array | list[float]) -> list[rr.TimeColumn]:
    """Return the column of times [s] of rows."""
    if isinstance(times, list):  # rerun rounds these one by one
        times = np.rint(1e9 * np.array(times, float)).astype("timedelta64[ns]")
    return [rr.TimeColumn(TIMELINE, duration=times)]


def plain_markdown(text: str) -> str:
    """Return a text so that a document in Markdown shows its characters, and no link or image."""
    return "".join(f"\\{c}" if c in MARKDOWN else c for c in text)
