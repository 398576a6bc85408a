"""Marks do not depend on which engine measures distances, nor on coal and pinocchio at all."""

import json
import subprocess
import sys

import pytest

from tests.laws import first
from tests.near_misses import near_miss, sampled
from tests.places import ROOT
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.in_words import verdict

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
    assert json.loads(done.stdout) == ["fcl", str(grade.mark), kinds]


def test_the_evidence_names_the_engine_and_its_error() -> None:
    case = near_miss(2)
    by_coal = verdict(check_collisions(case.scene, case.record)).evidence
    by_fcl = verdict(check_collisions(case.scene, case.record, engine="fcl")).evidence
    assert by_coal["method"] == "certified"
    assert by_fcl["method"] == "certified, by fcl with an error of 0.3 mm"


@pytest.mark.parametrize("seed", first(6, range(24)))
def test_fcl_misses_no_contact_and_makes_none_up(seed: int) -> None:
    case = near_miss(seed)
    exact = check_collisions(case.scene, case.record)
    found = check_collisions(case.scene, case.record, engine="fcl")
    names = {event.second for event in found.contacts}
    doubtful = {event.second for event in found.undetermined}
    assert names <= {event.second for event in exact.contacts}
    if len(sampled(case)):
        assert case.kind in names | doubtful
    if found.clearance is not None and exact.clearance is not None:
        slack = found.clearance.tolerance_m + exact.clearance.tolerance_m
        assert abs(found.clearance.distance_m - exact.clearance.distance_m) <= slack
