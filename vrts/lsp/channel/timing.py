"""When each motion of a program ends, and how near it comes, for the end of its line."""

from typing import NamedTuple

MOST_TIMES = 3  # of one step that are told
STEP_S = 0.05  # between samples of the clearance


class Timing(NamedTuple):
    """The motions of one line."""

    line: int  # from 1
    ends_s: tuple[float, ...]  # the first few times, since the program began [s]
    takes_s: float  # how long the first one takes [s]
    times: int  # how often the line moved the arm
    clearance_mm: float | None = None  # the least that was sampled; None: far, or no scene


def hint(timing: Timing) -> str:
    """Return what to show behind a motion."""
    shown = ", ".join(f"{end:.1f}" for end in timing.ends_s)
    text = f"{shown}{' ...' if timing.times > len(timing.ends_s) else ''} s"
    near = timing.clearance_mm
    return text if near is None else f"{text}, {near:.0f} mm"
