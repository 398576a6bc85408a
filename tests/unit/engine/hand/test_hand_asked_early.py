"""HAND asked for when the hand has been told to act, but does not act yet."""

import pytest

from tests.support_engine import runs


@pytest.mark.parametrize(
    ("body", "hand"),
    [
        ("CLOSE\nMOVE a\nTYPE HAND", "0"),
        ("OPEN\nMOVE a\nTYPE HAND", "0"),
        ("OPENI\nOPEN\nMOVE a\nTYPE HAND", "1"),
        ("OPENI\nCLOSE\nMOVE a\nTYPE HAND", "1"),
        ("OPENI\nMOVE a\nCLOSE\nMOVE b\nTYPE HAND", "1"),
        ("OPENI\nCLOSE\nMOVE a\nBREAK\nTYPE HAND", "0"),
    ],
)
def test_it_is_as_it_was_until_the_motion_begins(body: str, hand: str) -> None:
    assert runs(body).output.split() == [hand]
