"""A log beside a run: errors before and after the fit of offsets, and the timing of motions."""

from dataclasses import dataclass

import numpy as np

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.engine.run import Run
from vrts.pipeline.refused import Refused
from vrts.validate.clock import clock_shift
from vrts.validate.errors import Errors, errors_of, lengths, measures
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.log.log_units import note
from vrts.validate.offsets import Offsets, Wanted, fit_offsets
from vrts.validate.sampling import extent_of, moving
from vrts.validate.timing import Timing, timings

NOTHING_MOVES = Rule("V889", "nothing-moves")
LOG_SHORT = Rule("V890", "log-short")
OTHER_MOTION = Rule("V891", "other-motion")

SAME_CLOCK_S = 0.5  # a clock that is off by less is taken as it is, before anything is fitted
SHORT_S = 0.25  # of motion that the log may lack without a word
OTHER_SHARE = 0.05  # of the extent of the path: a larger error (RMS) is another motion
OTHER_LEAST_M = 0.02


@dataclass(frozen=True, slots=True)
class Comparison:
    """A log compared with a run."""

    run: Run
    log: RobotLog
    before: Errors  # by the log's own clock, or by one that is right to about 20 ms
    after: Errors  # with the offsets
    shift_s: float  # what was added to times of the log before anything was fitted
    offsets: Offsets
    wanted: Wanted
    timings: tuple[Timing, ...]
    findings: tuple[Diagnostic, ...]


def read_and_compare(run: Run, given: GivenLog, wanted: Wanted) -> Comparison:
    """Return the comparison of a log that is read first; raises as `read_log` and `compare`."""
    must_move(run)
    return compare(run, read_log(given, extent_of(run)), wanted)


def must_move(run: Run) -> None:
    """Refuse a run in which nothing moves.

    Raises:
        Refused: It is one.
    """
    start, end = moving(run)
    if end <= start:
        raise Refused((_still("the program moves nothing", "a program that moves the arm"),))


def compare(run: Run, log: RobotLog, wanted: Wanted) -> Comparison:
    """Return a log compared with a run.

    Args:
        run: The run.
        log: The log.
        wanted: Which offsets of the real robot are fitted.

    Raises:
        Refused: The log has nothing that can be compared.
    """
    told = list(log.findings)
    log_must_move(log)
    shift = clock_shift(run, log)
    begun = 0.0 if abs(shift) < SAME_CLOCK_S else shift
    if begun:
        way = "behind" if shift > 0.0 else "ahead"
        told.append(
            note(f"the clock of the log is {abs(shift):.2f} s {way} of the run: taken into account")
        )
    fitted = fit_offsets(run, log, shift if wanted.time else begun, wanted)
    offsets = fitted.offsets
    before = errors_of(run, log, Offsets(begun))
    after = errors_of(run, log, offsets)
    if not len(after.times) or not len(before.times):
        raise no_instant_in_common()
    told += fitted.findings
    told += _short(run, log, offsets)
    told += _other_motion(run, after)
    return Comparison(
        run,
        log,
        before,
        after,
        begun,
        offsets,
        wanted,
        tuple(timings(run, log, offsets)),
        tuple(told),
    )


def log_must_move(log: RobotLog) -> None:
    """Refuse a log in which nothing moves.

    Raises:
        Refused: It is one.
    """
    values = log.joints if log.joints is not None else log.positions
    assert values is not None
    known = values[np.isfinite(values).all(axis=1)]
    if len(known) < 2 or float(np.ptp(known, axis=0).max()) == 0.0:
        raise Refused((_still("the arm stands still in the log", "values that change"),))


def no_instant_in_common() -> Refused:
    """Return what is raised where a log is of another time than the run."""
    return Refused((_still("the log and the run have no instant in common", "the same clock"),))


def _still(headline: str, expected: str) -> Diagnostic:
    return error(
        NOTHING_MOVES,
        headline,
        notes=(f"expected {expected}",),
        help=("log the program while the arm carries it out",),
    )


def _short(run: Run, log: RobotLog, offsets: Offsets) -> list[Diagnostic]:
    start, end = moving(run)
    first, last = log.times[0] + offsets.time_s, log.times[-1] + offsets.time_s
    missing = max(first - start, 0.0) + max(end - last, 0.0)
    if missing < SHORT_S:
        return []
    return [
        warning(
            LOG_SHORT,
            f"the log lacks {missing:.2f} s of the {end - start:.2f} s in which the arm moves",
            notes=(
                (
                    f"expected samples from {start:.2f} to {end:.2f} s of the run;"
                    f" they go from {first:.2f} to {last:.2f} s"
                ),
            ),
            data={"missing_s": missing},
        )
    ]


def _other_motion(run: Run, after: Errors) -> list[Diagnostic]:
    off = measures(lengths(after)).rms
    extent = extent_of(run).position_m
    if off < max(OTHER_SHARE * extent, OTHER_LEAST_M):
        return []
    return [
        warning(
            OTHER_MOTION,
            "the log seems to be of another motion, or of another robot",
            notes=(
                (
                    f"the tool is {1e3 * off:.0f} mm off (RMS) on a path that is"
                    f" {1e3 * extent:.0f} mm long and wide"
                ),
            ),
            help=("compare program, scene and arm with those of the log",),
            data={"rms_m": off, "extent_m": extent},
        )
    ]
