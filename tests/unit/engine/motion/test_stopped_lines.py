"""The operator stops a line that would have failed, and goes on."""

from tests.support_engine import driven, lines, main, words
from tests.support_programs import codes
from tests.unit.engine.motion.test_faulty_lines import FAR
from vrts.engine.memory.records import Ending
from vrts.ir.commands import Abort, Proceed, Retry


def test_the_operator_may_leave_it_out() -> None:
    run = driven(main(FAR.format("")), 20.0, (2.0, Abort()), (6.0, Proceed()))
    assert codes(run) == []
    assert [text for _, text in lines(run)] == ["next"]
    assert run.ending is Ending.COMPLETED


def test_the_operator_may_have_it_done_again() -> None:
    run = driven(main(FAR.format("")), 20.0, (2.0, Abort()), (6.0, Retry()))
    assert words(run) == ["Joint 3 out of range"]
    assert len(run.motions) == 3
