"""What had to be assumed is told to people: what, how much, why, how to find out on the robot."""

from vrts.ask.assumed import assumed_text
from vrts.ask.collect import manual_files
from vrts.controllers.readings import BEFORE, READINGS
from vrts.report.assumptions import Assumption

MARKED = [
    Assumption("ir.ranges", "OUTPUTS", "range(1, 33)", "signals", "manual language/signals#ranges"),
    Assumption("robots.arms.puma", "_arm.speed", "degrees(90)", "assumed: no published speeds", ""),
    Assumption("why.hands", "NEAR", "0.15", "[m] from the pads", "", ("why.hands.hands",)),
]
TEXT = assumed_text(MARKED)
ALL = " ".join(TEXT.split())


def entry(title: str) -> str:
    """Return an entry on one line."""
    rows = TEXT.partition(f"\n  {title}\n")[2].partition("\n\n")[0]
    assert rows, title
    return " ".join(rows.split())


def test_an_entry_says_what_how_much_why_and_how_to_find_out() -> None:
    found = entry("FINE, COARSE, NULL and NONULL")
    assert found.startswith("what At a stop the controller waits until the joints are near enough")
    assert "how much when the controller waits" in found
    assert "settling with FINE = 3 ticks (stops.fine_ticks; assumed: the words:" in found
    assert f"of vrts-1: waits (assumed: {BEFORE})" in found
    assert "why assumed: the words: [VALSummary2014]; the times: no document" in found
    assert "on the robot Measure by TIMER ten short motions" in found
    assert found.endswith("more vrts manual language/settings#settling")


def test_a_mark_in_the_source_stands_at_its_rule() -> None:
    assert "how much OUTPUTS = range(1, 33)" in entry("Which signals there are")
    assert ALL.count("OUTPUTS") == 1


def test_models_arms_and_what_is_of_vrts_alone() -> None:
    assert "  val2    VAL-II, as far as the documents go (usual)\n" in TEXT
    assert "0.016 s (assumed: V+ has 16 ms" in ALL
    arms, _, own = TEXT.partition("\nThe arms\n")[2].partition("\nWhat vrts itself goes by\n")
    assert "_arm.speed = degrees(90); assumed: no published speeds" in arms
    assert "`vrts validate --fit`" in arms
    assert "NEAR = 0.15" in own
    assert "used in why.hands.hands" in own


def test_every_field_of_a_model_that_is_assumed_is_told() -> None:
    for reading in READINGS:
        grounds = (reading.ground, *reading.others.values())
        if any(ground.status == "assumed" for ground in grounds):
            assert f"({reading.field}; " in ALL, reading.field


def test_every_entry_says_how_to_find_out() -> None:
    entries = TEXT.partition("\nThe arms\n")[0].split("\n    more ")
    assert len(entries) > 50
    assert [e for e in entries[:-1] if "\n    on the robot  " not in e] == []


def test_every_assumed_rule_of_the_manual_is_told() -> None:
    for page, text in manual_files().items():
        for section in text.split("\n## ")[1:]:
            if "\n- **Status:** assumed" in section:
                title = section.partition("\n")[0].replace("`", "")
                assert f"\n  {title}\n" in TEXT, f"{page}: {title}"
