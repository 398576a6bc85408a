"""Motions and the polynomials of the arm as columns; times are path times."""

from collections.abc import Mapping, Sequence

import numpy as np

from vrts.engine.history import ArmHistory
from vrts.engine.memory.records import ArmPiece, Motion
from vrts.engine.motion.time_scale import Knot, TimeScale
from vrts.engine.storage.columns import (
    check_below,
    column,
    real_rows,
    reals,
    whole_rows,
    wholes,
)
from vrts.engine.storage.container import Table
from vrts.engine.storage.damage import require
from vrts.engine.storage.plain import Plain, joints_of_numbers, pose_of_numbers
from vrts.ir.instructions import Interpolation
from vrts.robots.model import Configuration

JOINTS = 6
SHORT = 2  # added for a line that a fault stops
MOST_COEFFICIENTS = 16  # of one polynomial
LARGEST_COEFFICIENT = 1e15
LONGEST_S = 1e6
FASTEST = 100.0  # rate of the time scale
OVERLAP = 1e-6  # [s] by which knots and pieces may miss each other

LAYOUT: Mapping[str, tuple[str, int]] = {
    "pieces.times": ("<f8", 2),
    "pieces.motion": ("<u4", 0),
    "pieces.lengths": ("|u1", JOINTS),  # coefficients of each joint
    "pieces.coefficients": ("<f8", 0),
    # start and end, start and goal, X_WT, X_FT, speed fraction, deviation
    "motions.numbers": ("<f8", 40),
    "motions.kinds": ("|u1", 3),  # interpolation, blended, cut and SHORT
    "motions.cause": ("<u4", 0),
}

INTERPOLATIONS = tuple(Interpolation)


def write_arm(arm: ArmHistory, plain: Plain) -> dict[str, Table]:
    """Return the columns of an arm's motions."""
    lengths = [[len(row) for row in piece.rows] for piece in arm.pieces]
    numbers = [[c for row in piece.rows for c in row] for piece in arm.pieces]
    return {
        "pieces.times": column([[p.start_s, p.end_s] for p in arm.pieces], "<f8", 2),
        "pieces.motion": column([piece.motion for piece in arm.pieces], "<u4"),
        "pieces.lengths": column(lengths, "|u1", JOINTS),
        "pieces.coefficients": column([c for part in numbers for c in part], "<f8"),
        "motions.numbers": column([_numbers(motion) for motion in arm.motions], "<f8", 40),
        "motions.kinds": column(
            [
                [INTERPOLATIONS.index(m.interpolation), m.blended, m.cut + SHORT * m.short]
                for m in arm.motions
            ],
            "|u1",
            3,
        ),
        "motions.cause": column([plain.cause_number(m.cause) for m in arm.motions], "<u4"),
    }


def read_arm(
    tables: Mapping[str, Table], plain: Plain, start: Configuration, scale: TimeScale
) -> ArmHistory:
    """Return the motions.

    Raises:
        Damaged: The columns do not fit together.
    """
    motions = _read_motions(tables, plain)
    pieces = _read_pieces(tables, len(motions))
    check_scale(scale)
    return ArmHistory(start, pieces, motions, scale)


def check_scale(scale: TimeScale) -> None:
    """Check that a time scaling maps every run time to one path time.

    Raises:
        Damaged: It does not.
    """
    knots = scale.knots
    require(bool(knots) and 0.0 < scale.rate <= FASTEST, "the operator's speed is none")
    begins = knots[0].time_s == knots[0].path_s == 0.0 < knots[0].rate
    require(begins, "the operator's speed does not begin at 0 s")
    last = knots[-1]
    require(last.slope == 0.0 and last.rate > 0.0, "the operator's speed never becomes steady")
    for knot, following in zip(knots, (*knots[1:], None), strict=True):
        inside = 0.0 <= knot.rate <= FASTEST and abs(knot.slope) <= LARGEST_COEFFICIENT
        require(inside and knot.time_s <= LONGEST_S, "the operator's speed is out of range")
        require(knot.rate > 0.0 or knot.slope > 0.0, "the operator's speed never recovers")
        if following is None:
            continue
        lasts = following.time_s - knot.time_s
        end = knot.path_s + lasts * (knot.rate + 0.5 * lasts * knot.slope)
        joined = lasts >= 0.0 and abs(end - following.path_s) <= OVERLAP
        rate = knot.rate + lasts * knot.slope
        require(joined and rate >= -OVERLAP, "the operator's speed has a gap")


def scale_of(rate: float, knots: Sequence[Knot]) -> TimeScale:
    """Return a time scaling of its parts."""
    found = TimeScale(rate)
    found.knots = list(knots)
    return found


def _numbers(m: Motion) -> list[float]:
    X_WT, X_FT = m.X_WT, m.X_FT
    return [
        *(m.start_s, m.end_s, *m.start, *m.goal),
        *(*X_WT.rotation, *X_WT.translation, *X_FT.rotation, *X_FT.translation),
        *(m.speed_fraction, m.deviation_m),
    ]


def _read_motions(tables: Mapping[str, Table], plain: Plain) -> list[Motion]:
    numbers, kinds, causes = (tables[f"motions.{part}"] for part in ("numbers", "kinds", "cause"))
    require(len(numbers) == len(kinds) == len(causes), "columns of motions differ in length")
    _check_times(numbers[:, :2], "motions")
    require(
        bool((np.abs(numbers) < LARGEST_COEFFICIENT).all()), "a number of a motion is too large"
    )
    check_below(kinds[:, 0], len(INTERPOLATIONS), "the kinds of motions")
    check_below(kinds[:, 1], 2, "the kinds of motions")
    check_below(kinds[:, 2], 2 * SHORT, "the kinds of motions")
    check_below(causes, len(plain.causes), "the steps of motions")
    found: list[Motion] = []
    for row, (kind, blended, cut), cause in zip(
        real_rows(numbers), whole_rows(kinds), wholes(causes), strict=True
    ):
        found.append(
            Motion(
                INTERPOLATIONS[kind],
                row[0],
                row[1],
                joints_of_numbers(row[2:8]),
                joints_of_numbers(row[8:14]),
                pose_of_numbers(row[14:26]),
                pose_of_numbers(row[26:38]),
                row[38],
                row[39],
                plain.causes[cause],
                bool(blended),
                bool(cut % SHORT),
                bool(cut // SHORT),
            )
        )
    return found


def _read_pieces(tables: Mapping[str, Table], motions: int) -> list[ArmPiece]:
    times, motion, lengths, coefficients = (
        tables[f"pieces.{part}"] for part in ("times", "motion", "lengths", "coefficients")
    )
    require(len(times) == len(motion) == len(lengths), "columns of pieces differ in length")
    _check_times(times, "pieces")
    check_below(motion, motions, "the motions of pieces")
    check_below(lengths.reshape(-1), MOST_COEFFICIENTS + 1, "the coefficients of pieces", 1)
    require(
        int(lengths.sum(dtype=np.int64)) == len(coefficients), "coefficients of pieces are missing"
    )
    small = bool((np.abs(coefficients) < LARGEST_COEFFICIENT).all())
    require(small, "a coefficient of a piece is too large")
    found: list[ArmPiece] = []
    numbers = reals(coefficients)
    at = 0
    for (start, end), counts, number in zip(
        real_rows(times), whole_rows(lengths), wholes(motion), strict=True
    ):
        rows: list[tuple[float, ...]] = []
        for count in counts:
            rows.append(tuple(numbers[at : at + count]))
            at += count
        found.append(ArmPiece(start, end, tuple(rows), number))
    return found


def _check_times(times: Table, what: str) -> None:
    starts, ends = times[:, 0], times[:, 1]
    inside = bool(((starts >= -OVERLAP) & (ends < LONGEST_S)).all())
    require(inside, f"a time of {what} is out of range")
    following = bool((starts[1:] >= starts[:-1] - OVERLAP).all())
    ordered = following and bool((ends >= starts - OVERLAP).all())
    require(ordered, f"the times of {what} are not in order")
