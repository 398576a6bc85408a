"""python-fcl in a child: it may die, and only the question that it died of has no answer."""

import os
import subprocess
import sys

import numpy as np
import pytest

from tests.places import ROOT
from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.proposer import Questions
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape
from vrts.marking.proposer import by_fcl
from vrts.marking.proposer.by_fcl import ByFcl
from vrts.marking.proposer.process import Process

BOX = Box((0.0635, 0.0321, 0.0889))
ROD = Cylinder(0.001, 0.07225814648962738)
HULL = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)))

# An edge of the box touches the end of the rod exactly: fcl throws through C++ (std::logic_error)
# and the process ends with status 134.
BOX_TURNED = np.array(
    [
        (-0.8883728802915367, 0.29848623545642811, 0.3488546872346258),
        (-0.45231059882569569, -0.69938593188904141, -0.55342067224276836),
        (0.078795607443939181, -0.64943458909943097, 0.75632398264817291),
    ]
)
BOX_AT = np.array((-0.31764131131034995, 0.67943270788304344, 1.2538681605088564))
ROD_TURNED = np.array(
    [
        (0.70840657543871322, 0.68537119893810172, -0.16860143398365238),
        (-0.61906721653414987, 0.71809248329470254, 0.31796063726239376),
        (0.33899248559201839, -0.12086978572743737, 0.93299227735836521),
    ]
)
ROD_AT = np.array((-0.36520721289586627, 0.64777262688706749, 1.4140144358849878))


@pytest.fixture(autouse=True, params=["forked", "spawned"])
def how(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both ways in which the child is started answer alike."""
    if request.param == "forked" and sys.platform != "linux":
        pytest.skip("nothing is forked here")

    def started() -> Process:
        return Process(fork=request.param == "forked")

    monkeypatch.setattr(by_fcl, "Process", started)


def touching(*lifted: float) -> Questions:
    """Return questions about box and rod, the rod lifted so much; 0 is deadly."""
    count = len(lifted)
    return Questions(
        [BOX] * count,
        [ROD] * count,
        np.tile(BOX_TURNED, (count, 1, 1)),
        np.tile(BOX_AT, (count, 1)),
        np.tile(ROD_TURNED, (count, 1, 1)),
        ROD_AT + np.array([(0.0, 0.0, z) for z in lifted]),
    )


def side_by_side(*pairs: tuple[Shape, Shape], x: float) -> Questions:
    count = len(pairs)
    turned = np.tile(np.eye(3), (count, 1, 1))
    there = np.tile((x, 0.0, 0.0), (count, 1))
    first, second = zip(*pairs, strict=True)
    return Questions(first, second, turned, np.zeros((count, 3)), turned, there)


def test_its_answers_are_those_of_coal() -> None:
    shapes = (BOX, ROD), (ROD, HULL), (HULL, BOX), (BOX, HULL)
    asked = side_by_side(*shapes, x=0.4)._replace(  # faces that are parallel are not its strength
        rotation_a=np.tile(BOX_TURNED, (4, 1, 1)), rotation_b=np.tile(ROD_TURNED, (4, 1, 1))
    )
    with ByFcl() as by:
        theirs = by.propose(asked)
    ours = ByCoal().propose(asked)
    assert theirs.normal == pytest.approx(ours.normal, abs=1e-3)
    gaps = [((b - a) * n).sum(axis=1) for n, a, b in (ours, theirs)]
    assert gaps[0] == pytest.approx(gaps[1], abs=1e-4)


def test_only_the_question_that_it_dies_of_has_no_answer() -> None:
    with ByFcl() as by:
        alone = [by.propose(touching(z)).first for z in (0.05, 0.06, -0.05)]
        found = by.propose(touching(0.05, 0.0, 0.06, 0.0, -0.05))
        assert by.deaths == 2
    assert np.isnan(found.normal).any(axis=1).tolist() == [False, True, False, True, False]
    assert (found.first[[0, 2, 4]] == np.concatenate(alone)).all()


def test_after_some_deaths_nobody_is_asked_any_more() -> None:
    with ByFcl(most_deaths=2) as by:
        found = by.propose(touching(0.05, 0.0, 0.06, 0.0, 0.05, 0.0))
        assert np.isnan(found.normal).any(axis=1).tolist() == [False, True, False] + [True] * 3
        assert np.isnan(by.propose(touching(0.05)).normal).all()
        assert by.deaths == 2


def test_a_child_that_takes_too_long_is_ended() -> None:
    with ByFcl(longest_s=0.0, most_deaths=1) as by:
        found = by.propose(touching(*[0.05] * 5000))
        assert by.deaths == 1
    assert np.isnan(found.normal[-1]).all()


def test_a_child_that_was_killed_is_replaced() -> None:
    with ByFcl() as by:
        before = by.propose(touching(0.05))
        by.kill()
        by.propose(touching(0.05))
        after = by.propose(touching(0.05))
    assert (before.first == after.first).all()


def test_shapes_that_come_and_go_are_not_taken_for_each_other() -> None:
    with ByFcl() as by:
        for size in np.linspace(0.01, 0.2, 40).tolist():
            found = by.propose(side_by_side((Box((size, size, size)), BOX), x=0.5))
            assert found.first[0, 0] == pytest.approx(size, abs=1e-6)


def test_a_flat_hull_is_not_answered() -> None:
    flat = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.1, 0.1, 0.0)))
    with ByFcl() as by:
        found = by.propose(side_by_side((BOX, flat), (BOX, ROD), x=0.5))
        assert by.deaths == 0
    assert np.isnan(found.normal[0]).all()
    assert np.isfinite(found.normal[1]).all()


def test_nothing_is_left_behind() -> None:
    open_before = set(os.listdir("/proc/self/fd")) if os.path.isdir("/proc/self/fd") else set[str]()
    with ByFcl() as by:
        by.propose(touching(0.05, 0.0, 0.05))
    assert by._process is None  # pyright: ignore[reportPrivateUsage]
    if open_before:
        assert set(os.listdir("/proc/self/fd")) == open_before


def test_the_asking_process_never_loads_fcl() -> None:
    program = (
        "import sys, numpy as np\n"
        "from tests.unit.marking.proposer.test_by_fcl import ByFcl, touching\n"
        "with ByFcl() as by:\n"
        "    assert np.isfinite(by.propose(touching(0.05)).first).all()\n"
        "print([m for m in sys.modules if m.partition('.')[0] == 'fcl'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert done.stdout == "[]\n"
