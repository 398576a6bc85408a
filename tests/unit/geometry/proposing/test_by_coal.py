"""Coal as a proposer: what it proposes for each question, and what it cannot harm."""

import numpy as np
import pytest

from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.nobody import Nobody
from vrts.geometry.proposing.proposer import Questions
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

BOX = Box((0.1, 0.1, 0.1))
FLAT = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.1, 0.1, 1e-12)))


def asked(*pairs: tuple[Shape, Shape, float]) -> Questions:
    """Return questions about pairs, the second of each so far along x."""
    count = len(pairs)
    turned = np.tile(np.eye(3), (count, 1, 1))
    there = np.array([(x, 0.0, 0.0) for _, _, x in pairs])
    return Questions(
        [a for a, _, _ in pairs],
        [b for _, b, _ in pairs],
        turned,
        np.zeros((count, 3)),
        turned,
        there,
    )


def test_each_question_has_its_answer_in_order() -> None:
    found = ByCoal().propose(
        asked((BOX, BOX, 0.3), (BOX, Cylinder(0.03, 0.05), -0.4), (BOX, BOX, 0.19))
    )
    assert found.normal == pytest.approx(np.array([(1, 0, 0), (-1, 0, 0), (1, 0, 0)]), abs=1e-6)
    assert found.first[:, 0] == pytest.approx([0.1, -0.1, 0.1], abs=1e-5)
    assert found.second[:, 0] == pytest.approx([0.2, -0.37, 0.09], abs=1e-5)


def test_a_flat_hull_which_would_end_the_process_is_not_put_to_coal() -> None:
    found = ByCoal().propose(asked((BOX, FLAT, 0.3), (FLAT, BOX, 0.3), (BOX, BOX, 0.3)))
    assert np.isnan(found.normal[:2]).all()
    assert found.normal[2] == pytest.approx((1, 0, 0))


def test_shapes_that_come_and_go_are_not_taken_for_each_other() -> None:
    proposer = ByCoal()
    for size in np.linspace(0.01, 0.2, 200).tolist():  # each may lie where the last one lay
        found = proposer.propose(asked((Box((size, size, size)), BOX, 0.5)))
        assert found.first[0, 0] == pytest.approx(size, abs=1e-6)


def test_nobody_answers_nothing() -> None:
    found = Nobody().propose(asked((BOX, BOX, 0.3), (BOX, BOX, 0.1)))
    assert [part.shape for part in found] == [(2, 3)] * 3
    assert all(np.isnan(part).all() for part in found)


def test_the_proposer_of_a_process_is_coal_where_there_is_one() -> None:
    assert here().name == "coal"
