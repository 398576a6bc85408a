"""Any program at all can be asked about: no fault of the search, whatever outside may do."""

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.property.test_any_program import PROGRAMS
from tests.support_programs import ALONE, compiled
from vrts.check.verdict import Answer
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Afterwards, Again, Answers, Environment
from vrts.prove.prove import prove
from vrts.scene.model import Parts

ENVIRONMENTS = (
    Environment(),
    Environment(answers=Answers(("3", "bad")), again=Again(2, Parts.LEFT), misses=True),
    Environment(
        answers=Answers((), 0.0, 3.0, whole=True),
        stops=frozenset(Afterwards),
        speeds=(100.0, 40.0),
        again=Again(1, Parts.PUT_BACK),
    ),
)
FEW = Asking(states=150)


@given(PROGRAMS, st.sampled_from(ENVIRONMENTS))
@settings(max_examples=examples(25), deadline=None)
def test_any_program_can_be_looked_at(text: str, environment: Environment) -> None:
    found = prove(compiled(text, "val2+"), ALONE, environment, FEW, entry="main")
    assert (found.answer is Answer.VIOLATED) is bool(found.found)
    assert all(one.confirmed for one in found.found)
    assert found.answer is not Answer.HOLDS or not found.open
