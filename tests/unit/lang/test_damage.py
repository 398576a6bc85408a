"""Damage of one token in a program of V+ has an error where it is."""

import random

import pytest

from tests.strangers.damage import DOUBLED, DROPPED, KINDS, REPLACED
from tests.strangers.figures import errors_of, noticed
from vrts.lang.dialect import VPLUS

PROGRAM = """\
.PROGRAM pick.all(count, $names[], list[])
        AUTO REAL i, n, $line
        AUTO LOC place
        ATTACH (lun, 4) "TCP"
        FOR i = 1 TO count STEP 2
            READ (lun, 0) $line
            n = VAL($DECODE($line, ",", 0))+LEN($names[i])
            SET place = TRANS(list[i,0], list[i,1], 0, 0, 180, n*2)
            IF (n > 3) AND SIG(1001) THEN
                APPROS place, 50
                SPEED 20 MMPS ALWAYS
                MOVES place
                CLOSEI
                DEPARTS 50
            ELSE
                TYPE "nothing: ", /F8.2, n, /S
            END
            GRECTANGLE (20) i, n, 10, 20
            SIGNAL 33, -34
        END
        EXECUTE 1 pick.all(1, $names[], list[]), 1
        DETACH (lun)
.END
"""


def test_the_program_is_right() -> None:
    assert errors_of(PROGRAM, VPLUS) == ()


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS)
def test_damage_is_noticed_where_it_is(kind: str) -> None:
    chance = random.Random(7)
    found = [n for n in noticed(PROGRAM, VPLUS, chance, 400) if n.damage.kind == kind]
    wrong = [n for n in found if not n.damage.right]
    least = {DROPPED: 60, DOUBLED: 100, REPLACED: 100}[kind]
    assert len(wrong) >= least
    assert sum(n.there for n in wrong) >= 0.95 * len(wrong)
