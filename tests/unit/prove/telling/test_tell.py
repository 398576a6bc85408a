"""What is told of what seems wrong: nothing is doubted that was shown in another future."""

import pytest

from tests.unit.prove.explore.proofs import ALONE, FREE, module_of
from vrts.engine.memory.events import Found
from vrts.prove.asking import one_by_one
from vrts.prove.graph.suspects import Suspect
from vrts.prove.proof import Wrong
from vrts.prove.telling.confirm import Replays
from vrts.prove.telling.tell import Teller

FAILS = "x = 0\nDELAY 1\nBREAK\nx = 1/x\n"


def suspects(*code: str) -> list[Suspect]:
    """Return errors that seem to come: the first at its time, the others before anything does."""
    times = (1.2, *(0.0 for _ in code[1:]))
    return [
        Suspect(Wrong.ERROR, (one,), f"an error of {one}", time_s - 1.0, None, None, 0)
        for one, time_s in zip(code, times, strict=True)
    ]


@pytest.mark.parametrize("other", ["same", "V999"])
def test_what_was_shown_once_is_not_doubted(other: str) -> None:
    replays = Replays(module_of(FAILS), ALONE, FREE, "main", None)
    run = replays.run(FREE.scenario, 5.0)
    (code,) = (each.diagnostic.rule.code for each in run.events if isinstance(each, Found))
    teller = Teller(replays, FREE, ALONE.robot.arm.tick)
    wanted = code if other == "same" else other
    teller.tell(suspects(code, wanted), one_by_one)
    assert [one.wrong for one in teller.found] == [Wrong.ERROR]
    assert teller.doubtful == ([] if other == "same" else [f"an error of {other}"])
