"""The layouts of the monitor, character by character [manual language/monitor#layouts]."""

import math

from vrts.base.oat import pose_from_components
from vrts.base.units import DEG
from vrts.lang.dialect import VAL2
from vrts.monitor import listings
from vrts.monitor.programs import StoredProgram, compiled, listed, listing, step_text

READY = (0.0, -90.0 * DEG, 90.0 * DEG, 0.0, 0.0, 0.0)
PICK = pose_from_components(500, 200, 100, 90, 90, 0)
INSTALLED = {1: 32, 1001: 32, 2001: 256}


def test_where_shows_pose_joints_and_hand() -> None:
    X_WT = pose_from_components(-20.32, 149.09, 921.12, 90, -90, 0)
    assert listings.where_text(X_WT, READY, 0.0) == (
        " X/JT1     Y/JT2     Z/JT3     O/JT4     A/JT5     T/JT6     HAND\n"
        "    -20.32    149.09    921.12    90.000   -90.000     0.000      0.00\n"
        "     0.000   -90.000    90.000     0.000     0.000     0.000\n"
    )


def test_where_of_as_has_two_blocks() -> None:
    both = listings.where_of_as_text(PICK, READY)
    assert both.startswith("       JT1       JT2")
    assert both == (
        listings.where_of_as_text(PICK, READY, block=1)
        + listings.where_of_as_text(PICK, READY, block=2)
    )
    assert "   500.000   200.000   100.000     0.000   180.000     0.000" in both  # Z Y' Z''


def test_locations_come_before_precision_points() -> None:
    assert listings.locations_text({"#safe": READY, "pick": PICK, "a[10]": PICK, "a[2]": PICK}) == (
        "                 X/JT1     Y/JT2     Z/JT3     O/JT4     A/JT5     T/JT6\n"
        "a[2]            500.00    200.00    100.00    90.000    90.000     0.000\n"
        "a[10]           500.00    200.00    100.00    90.000    90.000     0.000\n"
        "pick            500.00    200.00    100.00    90.000    90.000     0.000\n"
        "#safe            0.000   -90.000    90.000     0.000     0.000     0.000\n"
    )


def test_no_value_has_a_negative_zero() -> None:
    X = pose_from_components(-1e-9, -1e-9, 0, 90, -90, -1e-9)
    assert "-0.0" not in listings.location_row(X)
    assert "-0.0" not in listings.joints_row((-1e-9, 0.0, -1e-9, 0.0, 0.0, -1e-9))
    assert math.copysign(1, -0.0) < 0  # which is what would be shown


def test_numbers_and_strings() -> None:
    rows = [("count", 5.0), ("pitch*2", 50.8), ("a.rather.long.name", 0.25), ("$msg", "PART")]
    assert listings.values_text(rows) == (
        'count     5\npitch*2   50.8\na.rather.long.name 0.25\n$msg      "PART"\n'
    )


def test_signals_in_groups_of_four_highest_left() -> None:
    assert listings.signals_text(frozenset({1, 5, 1004}), 1, INSTALLED) == (
        "  32 -    1    0000   0000   0000   0000   0000   0000   0001   0001\n"
        "1032 - 1001    0000   0000   0000   0000   0000   0000   0000   1000\n"
        "2032 - 2001    0000   0000   0000   0000   0000   0000   0000   0000\n"
    )


def test_signals_that_are_not_installed_are_dashes() -> None:
    outputs, inputs, internal = listings.signals_text(frozenset({2033}), 2, INSTALLED).splitlines()
    assert outputs == "  64 -   33" + "    " + "   ".join(["----"] * 8)
    assert inputs.startswith("1064 - 1033    ----")
    assert internal.endswith("0001")


def test_status() -> None:
    frames = [("main", 0, 7, "MOVES feeder")]
    text = listings.status_text((100.0, 100.0), "Robot program", "RUNNING", (2, 3), frames)
    assert text == (
        "Monitor speed:       100\n"
        "Program speed:       100\n"
        "Robot program:       RUNNING\n"
        "Completed cycles:      2\n"
        "Remaining cycles:      3\n"
        "Program name      Prio   Step\n"
        "main                 0      7   MOVES feeder\n"
    )
    endless = listings.status_text((50.0, 12.5), "Robot program", "RUNNING", (0, -1), [])
    assert "Remaining cycles: Infinite\n" in endless
    assert "Program speed:      12.5\n" in endless


def test_switches_two_in_a_row() -> None:
    states = [("CP", True), ("POWER", True), ("TRACE", False)]
    assert listings.switches_text(states) == (
        " CP              ON     POWER           ON\n TRACE           OFF\n"
    )


def program(*lines: str) -> StoredProgram:
    return compiled(StoredProgram("pick.one", ".PROGRAM pick.one", lines), {}, {}, VAL2)


def test_a_listing_has_numbers_labels_and_indents() -> None:
    found = program("appro feeder,60", "MOVES FEEDER", "100 closei", "if n==1 then", "n=2", "end")
    assert listing(found, VAL2) == (
        ".PROGRAM pick.one\n"
        "    1.         APPRO feeder, 60\n"
        "    2.         MOVES feeder\n"
        "    3.  100    CLOSEI\n"
        "    4.         IF n == 1 THEN\n"
        "    5.           n = 2\n"
        "    6.         END\n"
        ".END\n"
    )
    assert found.program is not None


def test_a_bad_line_is_kept_and_marked() -> None:
    found = program("READY", "MOVEE feeder")
    assert found.program is None
    assert found.bad == {2}
    assert listed(found, VAL2, [2]) == "    2.         ?MOVEE feeder\n"
    assert [d.rule.code for d in found.faults] == ["V120"]


def test_a_missing_end_makes_a_program_not_executable() -> None:
    found = program("IF n == 1 THEN", "n = 2")
    assert found.program is None
    assert found.bad == frozenset()
    assert [d.rule.code for d in found.faults] == ["V137"]


def test_steps_are_seen_with_what_else_is_in_memory() -> None:
    alone = program("MOVE part", "part = 5")
    assert alone.program is None
    assert compiled(program("x = part"), {}, {"part": PICK}, VAL2).program is None
    assert compiled(program("x = part"), {}, {"part": 5.0}, VAL2).program is not None


def test_text_of_a_step() -> None:
    assert step_text(program("100 moves  feeder ; slowly"), 1, VAL2).startswith("MOVES feeder")
