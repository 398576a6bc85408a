"""Nothing that is told depends on who proposes, nor on coal and pinocchio at all."""

import json
import subprocess
import sys

import pytest

from tests.laws import first
from tests.near_misses import near_miss, sampled
from tests.places import ROOT
from tests.proposers import PROPOSERS
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import CollisionReport

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
WITHOUT = """
import sys
from importlib.abc import MetaPathFinder
class Missing(MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("coal", "pinocchio"):
            raise ModuleNotFoundError(name)
import importlib.util
known = importlib.util.find_spec
gone = ("coal", "pinocchio")
importlib.util.find_spec = lambda name, *a: None if name in gone else known(name, *a)
sys.meta_path.insert(0, Missing())
import json
from pathlib import Path
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
found = assess(request_for(Path(sys.argv[1])))
assert not {"coal", "pinocchio"} & set(sys.modules)
engine = found.judgement.collisions.engine
print(json.dumps([engine, str(found.grade.mark), [loss.kind for loss in found.grade.losses]]))
"""


@pytest.mark.parametrize("name", ["solution.v2", "submissions/hits-base.v2"])
def test_example_01_has_the_same_mark_without_coal_and_pinocchio(name: str) -> None:
    from vrts.pipeline.assess import assess
    from vrts.pipeline.requesting import request_for

    path = EXAMPLE / name
    called = [sys.executable, "-c", WITHOUT, str(path)]
    done = subprocess.run(called, capture_output=True, text=True, check=True)
    grade = assess(request_for(path)).grade
    assert grade is not None
    kinds = [loss.kind for loss in grade.losses]
    assert json.loads(done.stdout) == ["own", str(grade.mark), kinds]


def told(report: CollisionReport) -> object:
    """Everything that is told of events and clearance, to a millisecond and a hundredth."""
    touches = (*report.contacts, *report.grazes, *report.undetermined)
    return (
        [len(own) for own in (report.contacts, report.grazes, report.undetermined)],
        [(t.parts, *(round(s, 3) for s in (t.start_s, t.end_s, t.deepest_s))) for t in touches],
        [round(touch.depth_m, 5) for touch in touches],
        [(m.parts, round(m.nearest_s, 3), round(m.distance_m, 5)) for m in report.near_misses],
        report.clearance and (report.clearance.bodies, round(report.clearance.distance_m, 5)),
    )


@pytest.mark.thorough
@pytest.mark.parametrize("by", ["own", "liar", "off", "plausible"])
@pytest.mark.parametrize("seed", first(4, range(24)))
def test_times_and_depths_do_not_depend_on_who_proposes(seed: int, by: str) -> None:
    case = near_miss(seed)
    usual = check_collisions(case.scene, case.record, proposer=PROPOSERS["coal"]())
    found = check_collisions(case.scene, case.record, proposer=PROPOSERS[by]())
    assert told(found) == told(usual)
    touching = case.kind in {event.second for event in found.contacts}
    assert touching == (len(sampled(case)) > 0)
