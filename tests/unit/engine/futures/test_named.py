"""Numbers for polynomials: what rounding leaves of the same is the same, and nothing else."""

from random import Random

import numpy as np
import pytest

from vrts.engine.futures.named import NO_FARTHER, Named, NoFarther
from vrts.engine.memory.records import ArmPiece


def piece(rows: tuple[tuple[float, ...], ...], start_s: float = 0.0) -> ArmPiece:
    return ArmPiece(start_s, start_s + 0.028, rows, 0)


def test_lists_on_both_sides_of_a_border_between_rounded_numbers_are_the_same() -> None:
    lists, draw = NoFarther(), Random(1)
    for _ in range(1_000):
        border = (draw.randrange(10**9) + 0.5) * 1e-9  # round(…, 9) goes up or down here
        exact = np.array([draw.uniform(-5.0, 5.0) for _ in range(23)] + [border])
        known = lists.number("cubic", exact)
        for _ in range(5):
            noise = np.array([draw.uniform(-4e-11, 4e-11) for _ in range(24)])
            assert lists.number("cubic", exact + noise) == known


def test_lists_that_differ_anywhere_have_numbers_of_their_own() -> None:
    lists = NoFarther()
    exact = np.linspace(-1.0, 2.0, 24)
    found = {lists.number("cubic", exact)}
    for k in range(24):
        for by in (1.01 * NO_FARTHER, -1.01 * NO_FARTHER):
            other = exact.copy()
            other[k] += by
            found.add(lists.number("cubic", other))
    assert len(found) == 49
    found.add(lists.number("another kind", exact))
    assert len(found) == 50


def test_differences_that_make_up_for_each_other_are_seen() -> None:
    lists = NoFarther()
    one, other = np.array([1.0, 2.0]), np.array([2.0, 1.0])
    assert lists.number("line", one) != lists.number("line", other)


def test_a_path_has_one_number_whenever_it_is_gone() -> None:
    named = Named()
    a, b = ((0.1, 0.2, 0.3),) * 6, ((0.4, 0.5),) * 6
    path = [piece(a), piece(b, 0.028)]
    later = [piece(a, 7.0), piece(b, 7.028)]
    assert named.chain(path, 0) == named.chain(later, 0)
    assert named.chain(path, 1) == named.chain(later, 1)
    assert named.chain(path, 0) != named.chain(path, 1)
    turned = [piece(b), piece(a, 0.028)]
    assert named.chain(turned, 0) != named.chain(path, 0)


@pytest.mark.parametrize("noise", [(3e-17,), (0.0, 9e-12), (-2e-16, 1e-10)])
def test_a_highest_power_that_rounding_has_left_tells_no_pieces_apart(
    noise: tuple[float, ...],
) -> None:
    named, moves, rests = Named(), (0.1, 0.2, 0.3), (0.4,)
    known = named.chain([piece((moves,) * 5 + (rests,))], 0)
    assert named.chain([piece((*(moves,) * 5, (*rests, *noise)))], 0) == known
    assert named.chain([piece((*(moves,) * 5, (*rests, 1e-6)))], 0) != known
