"""What completion offers at a place is what the compiler takes there, and nothing else."""

import pytest

from tests.unit.lsp.cursor import at
from vrts.base.source import SourceFile
from vrts.ir.values import Type
from vrts.lang.compiler import compile_source
from vrts.lsp.answers.completing import complete

NAMES = {"count": Type.REAL, "$text": Type.STRING, "part": Type.POSE, "#ready": Type.JOINTS}
TEXT = """.PROGRAM main
        {}
.END
.LOCATIONS
part            450 -120 -50 90 90 0
#ready          0 -90 90 0 0 0
.END
.REALS
count           12
.END
.STRINGS
$text           "one"
.END
"""


def taken(line: str, name: str) -> bool:
    text = TEXT.format(line.replace("|", name))
    return not any(d.is_error for d in compile_source(SourceFile("a.v2", text)).diagnostics)


@pytest.mark.parametrize(
    "line",
    [
        *("MOVE |", "MOVES |", "MOVE part:|", "APPRO |, 5", "APPRO part, |", "DEPARTS |"),
        *("SPEED |", "SPEED 3+|", "DELAY |", "SIGNAL |", "SIGNAL 5, |", "OPENI |", "MOVET part, |"),
        *("DRIVE |, 5, 50", "DRIVE 1, |, 50", "DRIVE 1, 5, |", "BASE |, 0, 0, 0", "TOOL |"),
        *("x = |", "x = 2*|", "$s = |", "SET p = |", "x = DX(|)", "x = LEN(|)", "x = SIG(|)"),
        *("x = INRANGE(|)", "MOVE SHIFT(| BY 1, 2, 3)", "MOVE SHIFT(part BY 1, |, 3)", "TYPE |"),
        *("FOR i = | TO 3\n        END", "PAUSE |"),
        *("IF | == 3 THEN\n        END", "WAIT |", "TIMER 1 = |", "MOVE TRANS(1, |)"),
    ],
)
def test_what_is_offered_is_what_compiles(line: str) -> None:
    document, offset = at(TEXT.format(line))
    offered = {p.text for p in complete(document, offset, [document]).proposals} & NAMES.keys()
    compiles = {name for name in NAMES if taken(line, name)}
    extra = {"$text"} if line.startswith(("IF", "WAIT")) else set[str]()  # may be compared there
    assert offered - extra == compiles - extra
