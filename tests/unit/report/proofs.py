"""A proof made by hand, for tests of what is written about it."""

from vrts.base.source import SourceFile, Span
from vrts.check.verdict import Answer
from vrts.engine.memory.events import Cause
from vrts.prove.proof import Branch, Covered, Decided, Proof, Step, What, Wrong, Wronged
from vrts.scene.model import Scenario

TEXT = SourceFile("lower.v2", ".PROGRAM lower()\n  WAIT SIG(1001)\n  MOVES low\n.END\n")
WAIT = Cause("lower", 1, Span(TEXT, 19, 33))
LOW = Cause("lower", 2, Span(TEXT, 36, 45))
COVERED = Covered(
    states=1234,
    decisions=56,
    merged=7,
    ends=1,
    motion_s=12.34,
    quantified=("input 1001: on or off in every tick",),
    assumed=("inputs come eventually",),
    dead=(Step("lower", 9, "no way leads there"),),
)
HOLDS = Proof(Answer.HOLDS, (), COVERED)
HITS = Wronged(
    Wrong.CONTACT,
    "the robot touches the table, 2.1 mm deep",
    3.5,
    LOW,
    (
        Decided(0.28, What.INPUT, 1001, True, WAIT),
        Decided(0.5, What.ANSWER, 0, "3\x1b[31m", WAIT),
        Decided(1.0, What.STOP, 0, "proceed", None),
    ),
    Scenario(inputs=((0.27, 1001, True),), answers=("3",)),
    confirmed=True,
)
ERROR = HITS._replace(wrong=Wrong.ERROR, headline="`x` is divided by zero", decisions=())
VIOLATED = Proof(Answer.VIOLATED, (HITS, ERROR), COVERED, tree=(Branch(None, None, ""),))
OPEN = Proof(Answer.UNDETERMINED, (), COVERED, open=("17 futures: the budget of states is spent",))
