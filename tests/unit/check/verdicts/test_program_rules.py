"""Rules about the text of a program: what it must use, must not use, and how long it may be."""

import pytest

from tests.support_programs import cans, program, ran
from vrts.base.source import SourceFile
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.demand_check import check_demands

BODY = " MOVE a\n BREAK\n MOVES b"
HEAD = '[task]\nscene = "cans-on-bases"\n[[goal]]\nobject = "can1"\non = "base2"\n'
TAIL = "[time]\nreference_s = 12\n"


def ruled(text: str, rule: str) -> Verdict:
    found, problems = read_task(SourceFile("task.toml", f"{HEAD}[[rule]]\n{rule}\n{TAIL}"), cans())
    assert found is not None, problems
    (verdict,) = check_demands(ran(text), found.demands)
    return verdict


def answer(text: str, rule: str) -> Answer:
    return ruled(text, rule).answer


def test_what_must_be_used_is_used() -> None:
    assert answer(program(BODY), 'must_use = "MOVES"') is Answer.HOLDS
    assert answer(program(BODY), 'must_use = "moves"') is Answer.HOLDS
    assert answer(program(BODY), 'must_use = "APPRO"') is Answer.VIOLATED


def test_comments_and_texts_do_not_count() -> None:
    text = program(' ; APPRO a, 50 and GOTO 10\n TYPE "GOTO APPRO"\n' + BODY + " ; GOTO")
    assert answer(text, 'must_use = "APPRO"') is Answer.VIOLATED
    assert answer(text, 'must_not_use = "GOTO"') is Answer.HOLDS


def test_what_is_never_reached_is_not_used() -> None:
    found = ruled(program(" IF FALSE THEN\n MOVES a\n END\n MOVE b"), 'must_use = "MOVES"')
    assert found.answer is Answer.VIOLATED
    (finding,) = found.findings
    assert finding.primary is not None
    assert (finding.primary.span.text, finding.primary.text) == ("MOVES a", "never reached")
    dead = program(BODY) + ".PROGRAM other\n APPRO a, 50\n.END\n"
    assert answer(dead, 'must_use = "APPRO"') is Answer.VIOLATED
    called = program(BODY + "\n CALL other") + ".PROGRAM other\n APPRO a, 50\n.END\n"
    assert answer(called, 'must_use = "APPRO"') is Answer.HOLDS


@pytest.mark.parametrize("step", ["GOTO 5", "IF n == 0 GOTO 5", "IF n > 3 GOTO 5"])
def test_a_jump_is_found_with_and_without_a_condition(step: str) -> None:
    found = ruled(program(f" n = 0\n {step}\n5 MOVE a"), 'must_not_use = "GOTO"')
    assert found.answer is Answer.VIOLATED
    (finding,) = found.findings
    assert finding.primary is not None
    assert finding.primary.span.text == step


def test_what_is_forbidden_is_found_where_it_is_never_reached_and_abbreviated() -> None:
    dead = program(" MOVE a\n IF FALSE THEN\n APPROS b, 50\n END")
    assert answer(dead, 'must_not_use = "APPROS"') is Answer.VIOLATED
    assert answer(program(" MOVE a\n DEPARTS 50"), 'must_not_use = "DEPARTS"') is Answer.VIOLATED
    assert answer(program(" MOVE a\n DELA 1"), 'must_not_use = "DELAY"') is Answer.VIOLATED


def test_a_variable_is_no_instruction() -> None:
    """`rea` would be READY, abbreviated, if no `=` followed."""
    assert answer(program(" rea = 1\n TYPE rea\n MOVE a"), 'must_not_use = "READY"') is Answer.HOLDS
    assert answer(program(" rea = 1\n TYPE rea\n MOVE a"), 'must_use = "READY"') is Answer.VIOLATED


# every line but the comment and the blank one is a step: 17 of them
STRUCTURED = """
; a comment
 n = 0
 IF n == 0 THEN
  n = 1
 ELSE
  n = 2
 END
 FOR i = 1 TO 2
  n = n+1
 END
 DO
  n = 1
 UNTIL n == 1
 CASE n OF
  VALUE 1:
   n = 3
 END
 CALL sub
"""


@pytest.mark.parametrize(("rule", "holds"), [("most_steps = 19", True), ("most_steps = 18", False)])
def test_steps_of_all_programs_count_with_every_word_of_structures(rule: str, holds: bool) -> None:
    text = program(STRUCTURED) + ".PROGRAM sub\n MOVE a ; there\n10 MOVES b\n.END\n"
    found = ruled(text, rule)
    assert found.evidence["steps"] == 19
    assert found.answer is (Answer.HOLDS if holds else Answer.VIOLATED)
    if not holds:
        (finding,) = found.findings
        assert finding.notes == ("17 in `main`, 2 in `sub`",)
