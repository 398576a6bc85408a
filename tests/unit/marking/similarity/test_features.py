"""What of a program counts as the same, whatever it is disguised as."""

import msgspec

from tests.unit.marking.similarity.support import ORIGINAL, disguised
from vrts.marking.similarity.features.extract import CHANNELS, Program, digests_of, features_of
from vrts.marking.similarity.features.feature import Channel
from vrts.marking.similarity.features.motion import motion_features
from vrts.marking.similarity.features.steps import steps_of
from vrts.marking.similarity.features.words import words_of
from vrts.marking.similarity.symbols import Reader
from vrts.marking.submission.sketch import Sketch, Stop
from vrts.pipeline.compiling.programs import compile_bytes

LOOP = """.PROGRAM main()
  OPENI
  FOR i = 1 TO 3
    APPRO part[i], 120
    MOVES part[i]
    CLOSEI
    DEPARTS 200
  END
.END
"""
WHILE = """.PROGRAM main()
  k = 1
  OPENI
  WHILE k <= 3 DO
    CALL fetch(p[k])
    k = k+1
  END
.END
.PROGRAM fetch(x)
  unused = 4
  APPRO x, h
  MOVES x
  TYPE "there"
  CLOSEI
  DELAY 0.01
  DEPARTS 100+100
.END
.PROGRAM never()
  READY
.END
.REALS
h 120
.END
"""


def deeds(text: str) -> list[str]:
    """Return what a program does with arm and hand, with numbers."""
    module = compile_bytes(text.encode(), "a").compilation
    assert module is not None
    assert module.module is not None
    names = ("Move", "Depart", "MoveHand")
    return [step.exact for step in steps_of(module.module) if step.name.split()[0] in names]


def test_a_while_a_call_and_filler_are_no_disguise_of_a_for() -> None:
    assert deeds(LOOP) == deeds(WHILE)
    assert len(deeds(LOOP)) == 5
    assert "120" in deeds(WHILE)[1]


def test_the_test_and_the_count_of_both_loops_are_one() -> None:
    def shapes(text: str) -> set[str]:
        module = compile_bytes(text.encode(), "a").compilation
        assert module is not None
        assert module.module is not None
        return {s.exact for s in steps_of(module.module) if s.name[:4] in ("Jump", "Assi")}

    assert shapes(LOOP) == shapes(WHILE)


def test_a_comparison_that_is_turned_round_is_the_same() -> None:
    text = ".PROGRAM a()\n  IF {} THEN\n    READY\n  END\n.END\n"
    one, two = text.format("SIG(1) AND HAND < 12"), text.format("12 > HAND AND SIG(1)")
    found = [compile_bytes(t.encode(), "a").compilation for t in (one, two)]
    steps = [steps_of(c.module) for c in found if c is not None and c.module is not None]
    assert steps[0][0].exact == steps[1][0].exact


def test_names_comments_and_layout_change_no_step() -> None:
    reader = Reader()
    one = digests_of(Program(ORIGINAL.encode()), "a", reader)
    two = digests_of(Program(disguised().encode()), "b", reader)
    shared = [
        len({*a} & {*b}) / max(1, len(a)) for a, b in zip(one.channels, two.channels, strict=True)
    ]
    by = dict(zip(CHANNELS, shared, strict=True))
    assert by[Channel.STEPS] > 0.7
    assert by[Channel.STEPS] > by[Channel.NUMBERS]


def test_other_values_and_names_change_nothing_of_the_manner_of_motion() -> None:
    """Speeds and what the hand does stay, however places and heights are changed."""
    other = LOOP.replace("120", "145").replace("200", "165").replace("part", "thing")
    slow = LOOP.replace("  OPENI\n  FOR", "  SPEED 30 ALWAYS\n  OPENI\n  FOR")

    def manner(text: str) -> set[object]:
        features = features_of(Program(text.encode()), "a", Reader())
        return {one.key for one in features if one.channel is Channel.MANNER}

    assert manner(LOOP) == manner(other) != set()
    assert manner(LOOP).isdisjoint(manner(slow))


def test_a_line_is_the_same_whatever_its_numbers_blanks_and_capitals() -> None:
    text = "; Ann\n.PROGRAM go(p1)\n  APPROS p1, 120 ; quickly up\n  DELAY 0.5\n.END\n"
    data = ".LOCATIONS\nspot 1 2 3 90 90 0\n.END\n"
    other = text.replace("120", "-95.5").replace("0.5", "2").replace("  APPROS p1", "appros  P1")

    def lines(text: str) -> dict[object, int]:
        features = features_of(Program(text.encode()), "a", Reader())
        return {one.key[0]: one.line for one in features if one.channel is Channel.LINES}

    assert lines(text + data) == lines(other)
    assert lines(data + text)["appros p1, # ; quickly up"] == 6  # of the file
    assert lines(text).keys() == {
        "; ann",
        ".program go(p1)",
        "appros p1, # ; quickly up",
        "delay #",
    }
    assert lines(text).keys() != lines(text.replace("quickly", "slowly")).keys()


def stop(x: int, y: int, z: int, line: int = 1, thing: str = "can1") -> Stop:
    return Stop(line, True, 50, (x, y, z), (0, 0, -100), thing, (x - 70, y, z), "", "", False)


def places(*stops: Stop) -> set[int]:
    return {f.digest for f in motion_features(Sketch("vrts.motion/1", stops))}


def test_a_shift_of_the_scene_leaves_what_lies_beside_things() -> None:
    here = (stop(100, 0, 0), stop(1100, 0, 0), stop(1100, 700, 0))
    there = tuple(shifted(one, 3000) for one in here)
    assert places(*here) & places(*there)
    assert {f.kind for f in motion_features(Sketch("vrts.motion/1", here))} >= {"near", "stretch"}


def shifted(one: Stop, by: int) -> Stop:
    """Return a stop in a scene in which everything stands elsewhere."""
    x, y, z = one.at
    return msgspec.structs.replace(one, at=(x + by, y, z))


def test_places_that_the_scene_names_are_no_evidence() -> None:
    named = Stop(1, True, 50, (1, 2, 3), (0, 0, -100), "can1", (0, 0, 0), "", "", True)
    assert list(motion_features(Sketch("vrts.motion/1", (named,)))) == []


def test_every_feature_has_words_that_a_person_can_read() -> None:
    sketch = Sketch("vrts.motion/1", (stop(0, 0, 0), stop(900, 0, 0), stop(900, 800, 5)))
    program = Program(ORIGINAL.encode(), sketch)
    found = [words_of(feature) for feature in features_of(program, "a", Reader())]
    assert all(found)
    assert all(len(words) <= 220 for words in found)
    assert any(words.startswith("the same taught value to 0.01: (512.3, -81.7") for words in found)


def test_what_is_no_text_has_no_features() -> None:
    assert list(features_of(Program(b"\0\1\2"), "a", Reader())) == []


def test_calls_that_pile_up_are_read_soon() -> None:
    many = ",".join(["x"] * 12)
    parts = [
        f".PROGRAM p{k}(x)\n  CALL p{k + 1}(MAX({many}))\n  DRAW x, 1E38*1E38*x\n.END\n"
        for k in range(9)
    ]
    text = "".join([".PROGRAM main()\n  CALL p0(SIG(1))\n.END\n", *parts])
    found = list(features_of(Program(text.encode()), "a", Reader()))
    assert sum(len(repr(feature.key)) for feature in found) < 1_000_000


LOCATIONS = """.PROGRAM main()
  MOVE a
.END
.LOCATIONS
{} {} -480.25 {} 90 90 0
{} 959.93 {} {} 90 90 0
{} 780.41 259.84 {} 90 90 0
.END
"""


def offsets(text: str) -> set[tuple[object, ...]]:
    features = features_of(Program(text.encode()), "a", Reader())
    return {one.key for one in features if one.channel is Channel.OFFSETS}


def test_a_shift_along_one_axis_leaves_distances_to_the_last_digit_under_any_names() -> None:
    plain = LOCATIONS.format("a", 829.94, -226.57, "b", -479.8, -226.61, "c", -165.96)
    copy = LOCATIONS.format("q", 827.31, -222.57, "r", -477.03, -222.61, "s", -161.96)
    along = {key for key in offsets(plain) if key[0] == 2}
    assert along == {(2, 60.61), (2, 60.65), (2, 0.04)}
    assert along <= offsets(copy)
    assert not {key for key in offsets(plain) & offsets(copy) if key[0] == 0} - {(0, 179.52)}
    told = [f for f in features_of(Program(plain.encode()), "a", Reader()) if f.key == (2, 60.61)]
    assert words_of(told[0]) == "two taught values that lie exactly 60.61 mm apart along z"


def test_round_distances_tell_nothing_as_everybody_writes_round_numbers() -> None:
    assert not offsets(LOCATIONS.format("a", 830, -226.5, "b", -479.75, -226, "c", -165)) - {
        (0, 129.93),
        (0, 179.52),
        (0, 49.59),
        (1, 740.09),
        (1, 739.59),
    }


HANDLES = """.PROGRAM main()
  SPEED 75 ALWAYS
  APPRO a, {}
  SPEED 30
  MOVES a
  {}
  CLOSEI
  DELAY 0.2
  {}
  DEPARTS {}
  MOVES b
  OPENI
.END
"""


def hands(text: str) -> set[tuple[object, ...]]:
    features = features_of(Program(text.encode()), "a", Reader())
    return {one.key for one in features if one.kind in ("hand", "two hands")}


def test_how_the_hand_comes_waits_and_leaves_stays_whatever_stands_between() -> None:
    plain = HANDLES.format(120, "", "", 190)
    filled = HANDLES.format(115, 'TYPE "now"', "SIGNAL -7", 185)
    assert hands(plain) == hands(filled)
    assert len(hands(plain)) == 3
    assert hands(plain) != hands(plain.replace("0.2", "0.3"))
    assert hands(plain) != hands(plain.replace("SPEED 30", "SPEED 40"))
    found = features_of(Program(plain.encode()), "a", Reader())
    words = {words_of(one) for one in found if one.kind == "hand"}
    said = (
        "the same around the hand, whatever stands between: MOVES at 30 %, CLOSEI, a wait of 0.2 s"
    )
    assert any(one.startswith(said) for one in words), words
