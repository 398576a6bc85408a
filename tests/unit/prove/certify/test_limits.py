"""Joints that are too fast are told as the check of limits tells them, each motion once."""

from math import radians

import pytest

from tests.property.test_futures import Told
from tests.support_certify import driven
from tests.support_programs import ALONE, compiled, program
from vrts.base.stack import deep_stack
from vrts.check.verdicts.limits import check_limits
from vrts.engine.controller import execute
from vrts.prove.certify.certifier import Certifier
from vrts.scene.model import Scenario

FAST = "DRIVE 2, 45, 100\nDRIVE 3, 30, 100\nDRIVE 5, 6, 100\nHERE p\nMOVES SHIFT(p BY 0,-400,0)"
SLOW = 31.0  # [%] would do


@pytest.mark.parametrize("speed", [100.0, 60.0, 25.0])
@deep_stack()
def test_joints_that_are_too_fast_are_told(speed: float) -> None:
    module, scenario = compiled(program(FAST)), Scenario(monitor_speed=speed)
    run = execute(module, ALONE, scenario)
    certifier = Certifier(ALONE)
    told = driven(certifier, Told(module, ALONE, scenario, frozenset()).ticks()).beyond
    known = [found for found in check_limits(run).findings if found.rule.code == "V302"]
    assert bool(told) is bool(known) is (speed > SLOW)
    if known:
        (finding,) = known
        fastest = max(told, key=lambda one: one.value / one.limit)
        assert fastest.speed
        assert fastest.joint + 1 == finding.data["joint"]
        assert fastest.value == pytest.approx(radians(float(str(finding.data["speed_deg_s"]))))
        assert finding.moment is not None
        assert fastest.time_s == pytest.approx(finding.moment.time_s, abs=1e-6)
    again = driven(certifier, Told(module, ALONE, scenario, frozenset()).ticks(), 100).beyond
    assert not again
