"""What a student's report leaves out, and what those who mark read in addition."""

from dataclasses import replace
from fractions import Fraction

from tests.support_runs import assessment
from tests.unit.report.page.test_html import Reader
from vrts.base.source import SourceFile
from vrts.check.verdict import ContactEvent, NearMiss
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience, for_student, needs_review
from vrts.report.page.page import page
from vrts.report.plain import bare_name

DISPUTE = "left finger and can1 at 1.3 s: coal −0.31 mm, fcl +0.12 mm"
RANGE = "to be reviewed: the mark is between 6.2 and 8.5"


def disputed() -> Assessment:
    """Return a run of which one touch is undetermined and about which two engines disagree."""
    a = assessment()
    assert a.judgement is not None
    assert a.judgement.collisions is not None
    assert a.grade is not None
    report = a.judgement.collisions
    doubtful = report.contacts[0]._replace(second="base2", parts=("palm", "base2"))
    collisions = replace(
        report, undetermined=(doubtful,), disagreements=(DISPUTE,), certified=False
    )
    verdict = replace(a.judgement.verdicts[0], evidence={"disagreements": DISPUTE, "contacts": 1})
    verdicts = (verdict, *a.judgement.verdicts[1:])
    obstacles = ("the held can1 hits base1", RANGE, f"to be reviewed: two engines: {DISPUTE}")
    return replace(
        a,
        judgement=replace(a.judgement, verdicts=verdicts, collisions=collisions),
        grade=replace(a.grade, lowest=Fraction(31, 5), obstacles=obstacles),
    )


def test_a_student_reads_that_a_person_looks_not_what_engines_and_marks_may_be() -> None:
    told = for_student(disputed())
    assert told.grade is not None
    assert told.grade.lowest is None
    assert len(told.grade.obstacles) == 2
    assert "by a person" in told.grade.obstacles[1]
    assert DISPUTE not in repr(told.judgement)
    assert needs_review(disputed())
    assert needs_review(told)
    assert not needs_review(assessment())


def test_pages_of_the_two_audiences() -> None:
    a = disputed()
    student = page(a, {}, more=3)
    grader = page(a, {}, audience=Audience.GRADER, hidden=("target can1",))
    for text in (DISPUTE, "6.2", "Facts for an appeal", "1" * 64, "hidden"):
        assert text in Reader(grader).text, text
    shown = Reader(student).text
    for text in (DISPUTE, "6.2", "Facts", "1" * 64):
        assert text not in student, text
    assert "To be reviewed by a person" in shown
    assert "Not all public checks passed; 3 more at marking." in shown
    assert "target can1hidden" not in shown
    assert "palm touches base2" in Reader(grader).text


def test_no_folder_of_a_machine_is_in_a_page() -> None:
    a = disputed()
    assert a.source is not None
    source = SourceFile("/home/anna/marks/submission-07.v2", a.source.text)
    for audience in Audience:
        text = page(replace(a, source=source), {}, audience=audience)
        assert "/home" not in text
    assert bare_name("C:\\Users\\anna\\a.v2") == "a.v2"
    assert bare_name("a.v2") == "a.v2"
    assert bare_name("/") == "/"


def test_near_misses_and_grazes_stand_in_a_table() -> None:
    a = assessment()
    assert a.judgement is not None
    assert a.judgement.collisions is not None
    (contact,) = a.judgement.collisions.contacts
    miss = NearMiss(
        *("robot", "base2", ("left finger", "base2"), 2.0, 2.2, 2.1, 0.0014),
        ((1.1, 0.2, -0.1), (1.1, 0.2, -0.102)),
        *(None, contact.cause),
    )
    graze: ContactEvent = contact._replace(depth_m=0.0001)
    report = replace(
        a.judgement.collisions, near_misses=(miss,), near_miss_m=0.005, grazes=(graze,)
    )
    text = page(replace(a, judgement=replace(a.judgement, collisions=report)), {})
    shown = Reader(text).text
    assert "near missleft finger passes base2 at 1.4 mm2" in shown
    assert "graze, costs nothingcan1 touches base1, 0.1 mm deep2" in shown
    assert "A near miss is nearer than 5 mm: assumed, since the task names none." in shown
    assert '"distanceMm":1.4' in text
