"""A child that is kept for many processes: its answers are those of one's own, and it may die."""

import os
import sys
from collections.abc import Generator

import numpy as np
import psutil
import pytest

from tests.unit.marking.proposer.test_by_fcl import touching
from vrts.marking.proposer.by_fcl import ByFcl
from vrts.marking.proposer.kept import Kept

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="nothing is forked here")


def nothing() -> None:
    """Limit nothing."""


@pytest.fixture
def kept() -> Generator[Kept]:
    one = Kept(nothing)
    yield one
    one.end()


def own(by: ByFcl) -> bool:
    """Return whether a child of one's own was started."""
    return by._process is not None  # pyright: ignore[reportPrivateUsage]


def test_it_answers_as_ones_own_child_does_and_spares_it(kept: Kept) -> None:
    asked = touching(0.05, 0.06, -0.05)
    with ByFcl() as by:
        alone = by.propose(asked)
    for _ in range(3):
        with ByFcl(kept=kept.address) as by:
            found = by.propose(asked)
            assert not own(by)
        for ours, theirs in zip(found, alone, strict=True):
            assert (ours == theirs).all()


def test_what_it_dies_of_is_asked_of_ones_own_child_and_another_is_kept(kept: Kept) -> None:
    deadly = touching(0.05, 0.0, 0.06)
    with ByFcl(kept=kept.address) as by:
        found = by.propose(deadly)
        assert by.deaths == 1  # of one's own: the first death cost no question its answer
    assert np.isnan(found.normal).any(axis=1).tolist() == [False, True, False]
    with ByFcl(kept=kept.address) as by:
        assert np.isfinite(by.propose(touching(0.05)).first).all()
        assert not own(by)


def test_without_it_ones_own_child_is_asked(kept: Kept) -> None:
    kept.end()
    with ByFcl(kept=kept.address) as by:
        assert np.isfinite(by.propose(touching(0.05)).first).all()
        assert own(by)
        assert by.deaths == 0


def test_both_of_its_processes_end_with_it() -> None:
    before = set(os.listdir("/proc/self/fd"))
    others = psutil.Process().children(recursive=True)
    one = Kept(nothing)
    with ByFcl(kept=one.address) as by:
        by.propose(touching(0.05))
    started = [one for one in psutil.Process().children(recursive=True) if one not in others]
    assert len(started) >= 2
    one.end()
    psutil.wait_procs(started, timeout=10)
    assert not any(process.is_running() for process in started)
    assert not os.path.exists(one.address)
    assert set(os.listdir("/proc/self/fd")) == before
