"""Goals of tasks: symmetries, several places, relations, phases, and tasks without any."""

from fractions import Fraction

import pytest

from tests.support_goals import SCENE, Move, faults_of, graded, results, run_of, task_of
from tests.support_programs import ran
from vrts.check.verdict import Answer
from vrts.check.verdicts.targets import verdicts
from vrts.engine.run import Run

BRICK = '[[goal]]\nobject = "brick"\non = "base1"\n'
ON_BASE1, ON_BASE2 = (900.0, -130.0, -200.0), (900.0, 130.0, -200.0)


@pytest.fixture(scope="module")
def half_turned() -> Run:
    return run_of(Move("brick", *ON_BASE1, turn=180))


@pytest.fixture(scope="module")
def quarter_turned() -> Run:
    return run_of(Move("brick", *ON_BASE1, turn=90))


def test_a_brick_may_be_turned_by_half_a_turn(half_turned: Run) -> None:
    (found,) = results(half_turned, BRICK)
    assert (found.share, found.orientation_deg) == (1, 0)
    assert graded(half_turned, BRICK).mark == 10


def test_unless_the_task_says_that_it_has_a_label(half_turned: Run) -> None:
    (found,) = results(half_turned, BRICK + 'symmetry = "none"\n')
    assert (found.share, found.orientation_deg) == (0, 180)


def test_a_quarter_turn_of_a_long_brick_is_told(quarter_turned: Run, half_turned: Run) -> None:
    (found,) = results(quarter_turned, BRICK)
    assert (found.share, found.orientation_deg) == (0, 90)
    assert "is turned 90 degrees" in graded(quarter_turned, BRICK).losses[0].sentence
    turned = BRICK + "turn_deg = {}\n"
    for turn, share in ((90, 1), (-90, 1), (270, 1), (0, 0), (45, 0)):
        assert results(quarter_turned, turned.format(turn))[0].share == share
    for turn, share in ((180, 1), (0, 1), (-180, 1), (90, 0)):
        assert results(half_turned, turned.format(turn))[0].share == share


EITHER = BRICK.replace('"base1"', '["base2", "base1"]')
CANS = '[[goal]]\nobject = ["can1", "can2"]\non = ["base1", "base2"]\n'


def test_either_base_will_do(half_turned: Run) -> None:
    (found,) = results(half_turned, EITHER)
    assert (found.share, found.where) == (1, "on base1")
    assert found.goal.title == "brick on base2 or base1"
    assert found.goal.check == "target brick"
    (missed,) = results(run_of(), EITHER)
    assert (missed.share, missed.where) == (0, "on base1")  # the nearer one is told
    assert graded(half_turned, EITHER).mark == 10


@pytest.mark.parametrize("crossed", [False, True])
def test_one_can_on_each_base(crossed: bool) -> None:
    first, second = (ON_BASE2, ON_BASE1) if crossed else (ON_BASE1, ON_BASE2)
    run = run_of(Move("can1", *first), Move("can2", *second))
    found = graded(run, CANS)
    assert found.mark == 10
    wheres = [r.where for r in results(run, CANS)]
    assert wheres == (["on base2", "on base1"] if crossed else ["on base1", "on base2"])
    half = graded(run_of(Move("can1", *first)), CANS)
    assert half.targets == Fraction(17, 4)
    shown = [row.points for row in half.earned if row.kind == "target"]
    assert shown == [half.mark, 0]  # 4.25 beside a mark of 4.3


def test_a_place_serves_once() -> None:
    """Two cans, and both bases wanted: the second can stands on the table."""
    run = run_of(Move("can1", *ON_BASE1))
    one, other = results(run, CANS)
    assert (one.share, one.where, other.share, other.where) == (1, "on base1", 0, "on base2")


def test_a_can_beside_a_base_that_is_taken_is_measured_from_the_other_one() -> None:
    run = run_of(Move("can1", *ON_BASE1), Move("can2", 790, -130, -300))
    assert [r.where for r in results(run, CANS)] == ["on base1", "on base2"]


def test_more_objects_than_places() -> None:
    text = '[[goal]]\nobject = ["can1", "can2", "brick"]\non = "base1"\n'
    run = run_of(Move("can2", *ON_BASE1))
    (found,) = results(run, text)
    assert (found.share, found.body) == (1, "can2")
    assert found.goal.check == "target can1 or can2 or brick on base1"
    assert graded(run, text).mark == 10
    two = text.replace('"base1"', '["base1", "base2"]')
    found = results(run_of(Move("brick", *ON_BASE2), Move("can2", *ON_BASE1)), two)
    assert [(r.share, r.body) for r in found] == [(1, "can2"), (1, "brick")]


def test_places_with_turns_of_their_own(quarter_turned: Run) -> None:
    text = (
        '[[goal]]\nobject = "brick"\n[[goal.place]]\non = "base2"\n'
        '[[goal.place]]\non = "base1"\nturn_deg = 90\n'
    )
    assert results(quarter_turned, text)[0].share == 1
    assert results(quarter_turned, text.replace("90", "0"))[0].share == 0


RELATIONS = [
    ('left_of = "can2"\nby_mm = 50', (750, 300, -300), 0),
    ('left_of = "can2"\nby_mm = 50', (750, 500.5, -300), 1),
    ('left_of = "can2"\nby_mm = 50', (750, 499.5, -300), 0),
    ('right_of = "can2"\nby_mm = 120', (750, 329, -300), 1),
    ('right_of = "can2"\nby_mm = 120', (750, 331, -300), 0),
    ('farther_than = "can2"\nby_mm = 100', (851, 300, -300), 1),
    ('farther_than = "can2"\nby_mm = 100', (849, 300, -300), 0),
    ('nearer_than = "base1"', (750, 300, -300), 1),
    ('nearer_than = "can2"', (800, 300, -300), 0),
    ('stacked_on = "base1"', (910, -110, -200), 1),
    ('stacked_on = "base1"\nposition_mm = 25', (910, -110, -200), 1),
    ('stacked_on = "base1"\nposition_mm = 10', (910, -110, -200), Fraction(1, 2)),
    ('stacked_on = "base2"', (910, -110, -200), 0),
    ('aligned_with = "can2"\nalong = "y"', (757, 300, -300), 1),
    ('aligned_with = "can2"\nalong = "y"', (770, 300, -300), Fraction(1, 2)),
    ('aligned_with = "can2"\nalong = "x"', (757, 300, -300), 0),
    ("from_mm = [800, 200, -301]\nto_mm = [900, 300, 0]", (831, 231, -300), 1),
    ("from_mm = [800, 200, -301]\nto_mm = [900, 300, 0]", (829, 231, -300), 0),
    ("from_mm = [800, 200, -301]\nto_mm = [900, 300, 0]\nposition_mm = 5", (829, 231, -300), 1),
]


@pytest.mark.parametrize(("wanted", "end", "share"), RELATIONS)
def test_relations(wanted: str, end: tuple[float, float, float], share: Fraction) -> None:
    text = f'[[relation]]\nobject = "can1"\n{wanted}\n'
    run = run_of(Move("can1", *end))
    (found,) = results(run, text)
    assert found.share == pytest.approx(share, abs=0.02)
    row = graded(run, text).earned[0]
    assert abs(row.points - row.most * found.share) <= Fraction(1, 20)  # rounded with the mark
    assert (row.answer is Answer.HOLDS) is (share == 1)
    assert bool(row.message) is (share != 1)


WORDS = [
    ('left_of = "can2"\nby_mm = 50', "is 200 mm too far to the right to be 50 mm left of `can2`"),
    ('stacked_on = "can2"', "does not stand on `can2`"),
    ('aligned_with = "base1"\nalong = "x"', "is 430 mm out of line with `base1`"),
    ("from_mm = [0, 0, 0]\nto_mm = [1, 1, 1]", "sticks out of its box by 779 mm"),
]


@pytest.mark.parametrize(("wanted", "words"), WORDS)
def test_what_is_missing_to_a_relation_is_told(wanted: str, words: str) -> None:
    found = graded(run_of(), f'[[relation]]\nobject = "can1"\n{wanted}\n')
    assert words in found.losses[0].sentence


def test_bricks_in_a_row_are_turned_alike(half_turned: Run, quarter_turned: Run) -> None:
    text = '[[relation]]\nobject = "brick"\naligned_with = "base1"\nalong = "x"\n'
    assert results(half_turned, text)[0].share == 1
    assert results(quarter_turned, text)[0].share == 1  # the base is square
    askew = run_of(Move("brick", *ON_BASE1, turn=20))
    (found,) = results(askew, text)
    assert (found.share, found.orientation_deg) == (0, 20)
    assert "turned 20 degrees away from `base1`" in graded(askew, text).losses[0].sentence


def test_a_relation_to_what_is_in_the_hand_does_not_count() -> None:
    text = '[[relation]]\nobject = "can1"\nleft_of = "brick"\n'
    assert results(run_of(), text)[0].share == 1
    held = run_of(Move("brick", *ON_BASE1, release=False))
    (found,) = results(held, text)
    assert found.share == 0
    assert "`brick` is still in the hand" in graded(held, text).losses[0].sentence


PHASES = BRICK + "gripped = 0.2\nlifted = 0.3\nlifted_mm = 100\n"


@pytest.mark.parametrize(
    ("moves", "ends", "gripped", "lifted", "share"),
    [
        ((), "", False, False, Fraction(0)),
        ((Move("can1", *ON_BASE1),), "", False, False, Fraction(0)),
        ((Move("brick", *ON_BASE1, release=False),), "", True, True, Fraction(1, 2)),
        ((Move("brick", 900, 0, -300),), "", True, True, Fraction(1, 2)),
        ((Move("brick", 920, -130, -200),), "", True, True, Fraction(3, 4)),
        ((Move("brick", *ON_BASE1),), "", True, True, Fraction(1)),
    ],
)
def test_phases(
    moves: tuple[Move, ...],
    ends: str,
    gripped: bool,
    lifted: bool,
    share: Fraction,
) -> None:
    run = run_of(*moves, ends=ends)
    (found,) = results(run, PHASES)
    assert (found.gripped, found.lifted) == (gripped, lifted)
    assert found.share == pytest.approx(share, abs=0.01)
    mark = graded(run, PHASES)
    assert sum(row.points for row in mark.earned) == mark.mark
    assert sum(loss.points for loss in mark.losses) == 10 - mark.mark


def test_what_was_lifted_and_is_elsewhere_has_not_reached_its_goal() -> None:
    run = run_of(Move("brick", 900, 0, -300))
    (finding,) = verdicts(tuple(results(run, PHASES)))[0].findings
    assert finding.rule.code == "V660"
    assert finding.headline.endswith("; it was gripped and lifted")


def test_lifted_is_as_high_as_the_task_says() -> None:
    text = ".PROGRAM main\nOPENI\nAPPRO g, 100\nMOVES g\nCLOSEI\nDEPARTS {}\nBREAK\nMOVES g\n.END\n"
    place = ".LOCATIONS\ng 750 -400 -240 90 90 0\n.END\n"
    for height, lifted in ((99, False), (100, True), (101, True)):
        (found,) = results(ran(text.format(height) + place, SCENE), PHASES)
        assert (found.gripped, found.lifted) == (True, lifted)
        words = "it was gripped and lifted" if lifted else "it was gripped, but was not lifted"
        assert words in graded(ran(text.format(height) + place, SCENE), PHASES).losses[0].sentence


PATH = (
    '[[via]]\nname = "gate"\nat_mm = [850, 0, 200]\nradius_mm = 90\n'
    '[[via]]\nname = "far"\nat_mm = [0, 0, 900]\n'
)


def test_a_task_of_via_points_needs_no_object() -> None:
    found = graded(run_of(Move("can1", *ON_BASE1)), PATH)
    assert (found.targets, found.vias) == (0, Fraction(17, 4))
    for row in found.earned[:2]:  # rounded with the mark
        assert row.kind == "via"
        assert abs(row.most - Fraction(17, 4)) <= Fraction(1, 20)
    assert sum(row.points for row in found.earned) == found.mark
    assert sum(loss.points for loss in found.losses) == 10 - found.mark
    nothing = graded(run_of(), PATH.replace("850, 0, 200", "0, 0, 950"))
    assert nothing.mark == 0


def test_a_task_of_rules_gives_points_for_coming_to_the_end() -> None:
    text = (
        '[[rule]]\nmust_use = "MOVES"\npoints = 3\n[[rule]]\nmust_not_use = "READY"\npoints = 6\n'
    )
    good = graded(run_of(Move("can1", *ON_BASE1)), text)
    assert (good.mark, good.earned[0].kind, good.earned[0].points) == (
        10,
        "program",
        Fraction(17, 2),
    )
    stopped = graded(run_of(Move("can1", *ON_BASE1), ends="MOVE nowhere"), text)
    assert stopped.mark == 0
    assert stopped.earned[0].points == 0
    for mark in (good, stopped):
        assert sum(row.points for row in mark.earned) == mark.mark
        assert sum(row.most for row in mark.earned) == 10
        assert sum(loss.points for loss in mark.losses) == 10 - mark.mark


FAULTS = [
    ("", [("V659", "task")]),
    (BRICK + "gripped = 0.5\nlifted = 0.5\n", [("V658", "lifted")]),
    (BRICK + "lifted_mm = 5\n", [("V658", "lifted_mm")]),
    (BRICK + 'symmetry = "some"\n', [("V606", '"some"')]),
    (
        BRICK + '[[goal]]\nobject = ["can1", "brick"]\non = "base2"\n',
        [("V653", '["can1", "brick"]')],
    ),
    ('[[goal]]\nobject = ["can1", "can7"]\non = "base1"\n', [("V606", '"can7"')]),
    ('[[goal]]\nobject = ["can1", "can1"]\non = "base1"\n', [("V605", '"can1"')]),
    ('[[goal]]\nobject = []\non = "base1"\n', [("V605", "[]")]),
    ('[[goal]]\nobject = "can1"\non = 3\n', [("V604", "3")]),
    ('[[goal]]\nobject = "can1"\non = ["base1", "base2"]\nat_mm = [1, 2]\n', [("V652", "[1, 2]")]),
    (
        '[[goal]]\nobject = "can1"\non = "base1"\n[[goal.place]]\non = "base2"\n',
        [("V652", "[[goal]]")],
    ),
    ('[[goal]]\nobject = "can1"\n[[goal.place]]\nturn_deg = 5\n', [("V652", "[[goal.place]]")]),
    ('[[relation]]\nobject = "can1"\n', [("V657", "[[relation]]")]),
    (
        '[[relation]]\nobject = "can1"\nleft_of = "can2"\nstacked_on = "can2"\n',
        [("V657", "[[relation]]")],
    ),
    ('[[relation]]\nobject = "can1"\nleft_of = "can1"\n', [("V657", '"can1"')]),
    ('[[relation]]\nobject = "base1"\nleft_of = "can1"\n', [("V651", '"base1"')]),
    ('[[relation]]\nobject = "can1"\nstacked_on = "can2"\nby_mm = 3\n', [("V657", "by_mm")]),
    ('[[relation]]\nobject = "can1"\naligned_with = "can2"\n', [("V657", "[[relation]]")]),
    ('[[relation]]\nobject = "can1"\nfrom_mm = [0, 0, 0]\n', [("V657", "[[relation]]")]),
    (
        '[[relation]]\nobject = "can1"\nfrom_mm = [0, 0, 0]\nto_mm = [1, 0, 1]\n',
        [("V657", "[1, 0, 1]")],
    ),
    (
        (
            '[[relation]]\nobject = "can1"\nleft_of = "can2"\n'
            '[[relation]]\nobject = "can1"\nright_of = "can2"\n'
        ),
        [("V657", "[[relation]]")],
    ),
    (
        (
            '[[relation]]\nobject = "can1"\nleft_of = "can2"\n'
            '[[relation]]\nobject = "can1"\nleft_of = "can2"\nby_mm = 30\n'
        ),
        [("V657", "[[relation]]")],
    ),
]


@pytest.mark.parametrize(("text", "faults"), FAULTS)
def test_faults_point_into_the_file(text: str, faults: list[tuple[str, str]]) -> None:
    assert faults_of(text) == faults


def test_titles() -> None:
    several = '[[goal]]\nobject = ["can1", "can2"]\non = ["base1", "base2"]\ntitle = "cans away"\n'
    assert [g.title for g in task_of(several).goals] == ["cans away: can1", "cans away: can2"]
    three = several.replace('"can2"]', '"can2", "brick"]')
    assert [g.title for g in task_of(three).goals] == ["cans away: on base1", "cans away: on base2"]
    at = '[[goal]]\nobject = "can1"\nat_mm = [800, 0, -300]\n'
    assert task_of(at).goals[0].title == "can1 in place"
    assert task_of(at + 'on = "table"\n').goals[0].title == "can1 on table"
