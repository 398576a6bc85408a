"""A name that stands for one array after the other has the elements of the one that is meant."""

from tests.support_programs import compiled, robot_alone
from tests.unit.debug.conditions.support import told_both
from vrts.debug.conditions.expression import Expressions
from vrts.debug.debugger import Debugger
from vrts.engine.controller import execute
from vrts.lang.dialect import DIALECTS

TEXT = """.PROGRAM main()
 a[1] = 1
 a[5] = 5
 CALL look(a[])
 b[1] = 2
 CALL look(b[])
 a[7] = 7
 CALL look(a[])
 CALL look(none[])
.END
.PROGRAM look(x[])
 n = n+1
 n = n+1
.END
.REALS
n 0
.END
"""
ASKED = ("x[5]", "x[1]+x[n]", "DEFINED(x[])", "DEFINED(x[5])", "LAST(x[])", "x[7]+0")


def test_expressions_about_an_argument_are_of_the_array_that_was_given() -> None:
    d = Debugger(execute(compiled(TEXT, "val2+"), robot_alone()), DIALECTS["val2+"])
    known = Expressions(d.run, d.dialect)
    passages, trace = d.passages(process=False), d.run.history.robot.trace
    inside = [k for k in range(passages.count) if passages.cause(k).program == "look"]
    assert len(inside) == 4 * 3, "its two steps, and its end"
    told: dict[str, set[str]] = {text: set() for text in ASKED}
    for k in (*inside, *inside[::-1]):  # forward, and back
        at = passages.instant(k)
        activation = trace.activation(at.finished)
        for text in ASKED:
            wanted, found = told_both(d, known, text, at, activation)
            assert repr(found) == repr(wanted), (text, at)
            told[text].add(repr(found))
    assert all(len(told[text]) > 1 for text in ASKED), told
