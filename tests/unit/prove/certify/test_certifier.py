"""What a certifier tells of a future is what the check of its whole run tells."""

from dataclasses import replace
from random import Random

import pytest

from tests.property.test_futures import Told
from tests.support_certify import Driven, differences, driven
from tests.support_programs import compiled
from tests.unit.prove.certify.carrying import Carried, carried
from tests.whole_programs.settings import setting
from vrts.base.remembered import Memory
from vrts.base.stack import deep_stack
from vrts.engine.controller import execute
from vrts.prove.certify.certifier import Certifier

USUAL = range(12)
SHARED, FUTURES = (505, 506, 507), 8
MORE = [pytest.param(k, marks=pytest.mark.thorough) for k in (*range(500, 505), *range(508, 530))]
MANY = [pytest.param(k, marks=pytest.mark.thorough) for k in range(12, 80)]


def certified(given: Carried, certifier: Certifier | None = None) -> Driven:
    """Drive the future of a program through a certifier."""
    scene = setting(given.scene).scene
    told = Told(compiled(given.text), scene, given.scenario, frozenset({1001}))
    return driven(certifier or Certifier(scene), told.ticks())


@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_contacts_are_those_of_the_run(number: int) -> None:
    given = carried(number)
    scene = setting(given.scene).scene
    run = execute(compiled(given.text), scene, given.scenario)
    assert not differences(scene, run, certified(given).contacts)


@deep_stack()
def test_what_was_certified_is_not_certified_again() -> None:
    given = carried(1)
    certifier = Certifier(setting(given.scene).scene)
    certified(given, certifier)
    known_s = certifier.motion_s
    certified(given, certifier)
    assert certifier.motion_s == known_s > 1.0


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*SHARED, *MORE])
@deep_stack()
def test_futures_that_share_motion_are_told_what_each_touches(number: int) -> None:
    """What a future touches is told of it, or the same bodies were told of one before."""
    given, draw = carried(number), Random(number)
    module, scene = compiled(given.text), setting(given.scene).scene
    certifier = Certifier(scene)
    known: set[tuple[str, str]] = set()
    memory = Memory()  # the arm goes nearly the same way in all of them: motion is planned once
    for k in range(FUTURES):
        inputs = ((draw.uniform(0.5, 9.0), 1001, True),) if k else ()
        scenario = replace(given.scenario, inputs=inputs)
        told = Told(module, scene, scenario, frozenset({1001}))
        with memory.in_use():
            contacts = driven(certifier, told.ticks(), 1000 * k).contacts
            run = execute(module, scene, scenario)
        wrong = differences(scene, run, contacts, frozenset(known))
        assert not wrong, (k, inputs, wrong)
        assert all(1000 * k <= one.future < 1000 * (k + 1) for one in contacts)
        known |= {(one.first, one.second) for one in contacts}
