"""What students are handed follows the task: the README is written from it, and held against it."""

import re
import shutil
import zipfile
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from vrts.assignments.handed import prose
from vrts.assignments.handed.facts import Fact
from vrts.assignments.handed.of_folder import handed_findings, readme_to_hand_out
from vrts.assignments.handed.prose import contradictions, said
from vrts.assignments.handed.readme import BEGIN, END, written
from vrts.assignments.handed.task_words import task_words
from vrts.base.diagnostic import Diagnostic, warning
from vrts.base.source import SourceFile
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.settings import load_task

EXAMPLES = sorted(place.parent for place in (ROOT / "examples").glob("*/task.toml"))
ALL = """
ordered = true
program = "main"
[[goal]]
object = "can1"
on = "base2"
position_mm = 3
orientation_deg = 2.5
symmetry = "upright"
lifted = 0.2
[[goal]]
object = "can2"
on = "base1"
turn_deg = 90
symmetry = "none"
[[relation]]
object = "can2"
left_of = "can1"
by_mm = 40
position_mm = 7
weight = 2
[[relation]]
object = "can2"
title = "can2 <!-- inside"
from_mm = [800, -100, -301]
to_mm = [1000, 100, -150]
[[via]]
name = "gap"
at_mm = [900, 0, 100]
radius_mm = 17
approach = [0, 0, -1]
cone_deg = 11
speed_mm_s = [5, 1500]
[[zone]]
name = "glass"
from_mm = [0, 1500, -1000]
to_mm = [500, 2000, 1000]
keeps_out = "robot"
points = 0.75
[[upright]]
object = "can1"
within_deg = 6
[[limit]]
tool_mm_s = 2500
[[rule]]
most_steps = 40
[time]
reference_s = 12
[mark]
total = 7.5
contacts_by = "depth"
zero_at = 4
[settings]
parameters = ["HAND.TIME"]
acceleration_percent = 80
[late]
due = 2030-11-30T23:59:00+01:00
grace_min = 10
per_day = 1
most = 5
[hints]
level = "place"
"""
SECRET = '[[via]]\nname = "secret"\nat_mm = [901, 2, 103]\nradius_mm = 291\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    lab = tmp_path / "lab"
    lab.mkdir()
    shutil.copy(EXAMPLES[0] / "task.toml", lab)
    shutil.copy(EXAMPLES[0] / "solution.v2", lab)
    (lab / "README.md").write_text(f"# Lab\n\n{BEGIN}\n{END}\n\nThe end.\n")
    return lab


def codes(folder: Path) -> list[tuple[str, int]]:
    found = handed_findings(folder, load_task(folder))
    return [(d.rule.code, d.primary.span.line if d.primary else 0) for d in found]


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda place: place.name)
def test_the_examples_say_what_their_tasks_say(example: Path) -> None:
    assert handed_findings(example, load_task(example)) == ()
    assert (example / "README.md").read_bytes() == readme_to_hand_out(example, load_task(example))


def test_every_number_of_a_task_is_told(folder: Path) -> None:
    (folder / "task.toml").write_text(f'[task]\nscene = "cans-on-bases"{ALL}')
    (folder / "staff").mkdir()
    (folder / "staff" / "task.toml").write_text(SECRET)
    setting = load_task(folder)
    assert setting.task is not None
    words = task_words(setting.task, setting.scene)
    for part in (
        "out of 7.5 points",
        "`main`",
        "within 3 mm and 2.5 degrees",
        "nothing from 4 times",
        "upside down",
        "in mm from the robot's shoulder: X forward, Y to the left, Z up",
        "is the middle of its underside",
        "can1 on base2 (X 1100, Y 230, Z -200), within",
        "can2 on base1 (X 950, Y -130, Z -150, turned by 90 degrees), within 10 mm",
        "Turns are counter-clockwise",
        "20 %",
        "`can2` is left of `can1` by 40 mm or more, within 7 mm",
        "box X 800 to 1000, Y -100 to 100, Z -301 to -150, all or nothing",
        "within 17 mm of X 900, Y 0, Z 100",
        "within 11 degrees",
        "5 mm/s or more",
        "1500 mm/s or less",
        "stays out of `glass`: X 0 to 500, Y 1500 to 2000, Z -1000 to 1000 (else 0.75 points lost)",
        "stays within 6 degrees of upright (else 0.75 points lost)",
        "2500 mm/s",
        "40 steps at most",
        "each millimetre of depth of a contact, as well: 0.07 points",
        "all contacts and drops together: 3.75 points at most",
        "no longer than 15 s",
        "nothing from 30 s on",
        "`SPEED.MAX`",
        "80 % at most",
        "2030-11-30 23:59:00+01:00; up to 10 min later costs nothing",
        "each day late that has begun: 1 point, 5 points at most",
        "hints: vrts may tell the line",
    ):
        assert part in words, part
    assert "<!--" not in words
    handed = readme_to_hand_out(folder, load_task(folder)).decode()
    for hidden in ("secret", "291", "901", "103"):
        assert hidden not in handed
    given = [float(x) for x in re.findall(r": ([\d.]+) points?$", words, re.MULTILINE)][1:6]
    assert sum(given[:4]) == pytest.approx(4.5, abs=0.01), words


def test_each_line_that_differs_is_told_once_and_mended(folder: Path) -> None:
    words = readme_to_hand_out(folder, load_task(folder)).decode()
    assert words.startswith("# Lab\n")
    assert words.endswith("\nThe end.\n")
    (folder / "README.md").write_text(words)
    assert codes(folder) == []
    task = folder / "task.toml"
    task.write_text(task.read_text().replace("position_mm = 10", "position_mm = 3"))
    lines = words.splitlines()
    goals = [n for n, line in enumerate(lines, 1) if "within 10 mm" in line]
    assert codes(folder) == [("V684", n) for n in goals]
    changed = [line for line in lines if "HAND.MAX" not in line]
    changed.insert(goals[-1], "- bring coffee: 2 points")
    (folder / "README.md").write_text("\n".join(changed) + "\n")
    found = codes(folder)
    assert [code for code, _ in found] == ["V684"] * 4
    assert goals[-1] + 1 in [line for _, line in found]
    (folder / "README.md").write_bytes(readme_to_hand_out(folder, load_task(folder)))
    assert codes(folder) == []


def test_a_readme_keeps_its_line_ends_and_gets_a_part_at_its_end() -> None:
    assert written("", "w\n") == f"{BEGIN}\n\nw\n\n{END}\n"
    first = written("# A\r\n", "w\n")
    assert first == f"# A\r\n\r\n{BEGIN}\r\n\r\nw\r\n\r\n{END}\r\n"
    assert written(first, "w\n") == first
    assert written(first, "v\n") == first.replace("\nw\r", "\nv\r")
    mixed = f"# A\r\n\nb\n\n{BEGIN}\n\nw\n\n{END}\nc\r\n"
    assert written(mixed, "v\n") == mixed.replace("\nw\n", "\nv\n")
    assert written("# A\r\n\nb\n", "w\n").startswith(f"# A\r\n\nb\n\n{BEGIN}\n\nw\n")


@pytest.mark.parametrize("text", [BEGIN, END, f"{END}\n{BEGIN}", f"{BEGIN}\n{END}\n{BEGIN}\n{END}"])
def test_markers_that_are_not_sound_are_refused(folder: Path, text: str) -> None:
    (folder / "README.md").write_text(f"# Lab\n{text}\n")
    assert [code for code, _ in codes(folder)] == ["V685"]
    with pytest.raises(Refused):
        readme_to_hand_out(folder, load_task(folder))


@pytest.mark.parametrize("code", ["```text\n{}\n```", "- an item\n\n  ~~~\n{}\n  ~~~"])
def test_markers_in_a_block_of_code_are_shown_and_do_not_count(folder: Path, code: str) -> None:
    shown = "# Lab\n\n" + code.format(f"{BEGIN}\nwithin 9 mm\n{END}") + "\n"
    (folder / "README.md").write_text(shown)
    assert codes(folder) == [("V684", 0)]
    handed = readme_to_hand_out(folder, load_task(folder)).decode()
    assert handed.startswith(f"{shown}\n{BEGIN}\n\n## What counts\n")
    (folder / "README.md").write_text(handed)
    assert codes(folder) == []
    assert readme_to_hand_out(folder, load_task(folder)).decode() == handed


@pytest.mark.parametrize(
    "text", [f"1. a\n   {BEGIN}\n   {END}", f"  {BEGIN}\n{END}", f"```\n{BEGIN}\n{END}", "~~~"]
)
def test_a_part_that_would_be_inside_a_list_or_code_is_refused(folder: Path, text: str) -> None:
    (folder / "README.md").write_text(f"# Lab\n\n{text}\n")
    assert [code for code, _ in codes(folder)] == ["V685"]
    with pytest.raises(Refused):
        readme_to_hand_out(folder, load_task(folder))


def test_a_description_with_a_marker_is_told_where_there_is_no_readme(folder: Path) -> None:
    task = folder / "task.toml"
    text = task.read_text().replace('description = """', f'description = """\n{BEGIN}')
    assert BEGIN in text
    task.write_text(text)
    (folder / "README.md").unlink()
    assert [code for code, _ in codes(folder)] == ["V685"]
    with pytest.raises(Refused):
        readme_to_hand_out(folder, load_task(folder))


def test_a_readme_of_before_has_no_part_and_gets_one(folder: Path) -> None:
    (folder / "README.md").write_text("# Lab\n")
    assert codes(folder) == [("V684", 0)]
    handed = readme_to_hand_out(folder, load_task(folder)).decode()
    assert handed.startswith(f"# Lab\n\n{BEGIN}\n\n## What counts\n")
    (folder / "README.md").unlink()
    assert codes(folder) == []
    assert readme_to_hand_out(folder, load_task(folder)).decode().startswith("# Cans on bases\n")


def test_a_readme_that_is_no_text_is_refused(folder: Path) -> None:
    (folder / "README.md").write_bytes("Übung".encode("latin-1"))
    with pytest.raises(CannotRead, match="not UTF-8"):
        handed_findings(folder, load_task(folder))


TRUE = (
    Fact("points", Fraction(20)),
    Fact("mm", Fraction(3), ("can1", "base2")),
    Fact("degrees", Fraction(5), ("can1", "base2")),
    Fact("s", Fraction("13.25")),
    Fact("s", Fraction("26.5")),
)
VIA = Fact("mm", Fraction(10), ("gap", "tool"))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("It must stand within 10 mm of the base.", ["10 mm"]),
        ("within 3 mm and 4 degrees", ["4 degrees"]),
        ("within 0.3 cm, within 3.0 mm", []),
        ("die Dose auf 10 mm genau abstellen", ["10 mm"]),
        ("innerhalb von 3,5 mm und höchstens 14 Sekunden", ["3,5 mm", "14 Sekunden"]),
        ("no longer than 13.3 s", []),
        ("out of 10 points, at most 4 points are lost", ["10 points"]),
        ("a tolerance of ± 5°", []),
        ("~~~\n```\nwithin 10 mm\n~~~\nwithin 9 mm\n```\nwithin 8 mm", ["9 mm"]),
        ("± 6°", ["6°"]),
        ("within **10 mm**, within about 9 mm, tolerance: 8 mm", ["10 mm", "9 mm", "8 mm"]),
        ("a 10-mm tolerance, 9 mm or less, 3 mm at most", ["10-mm"]),
        ("im Umkreis von 10 Millimetern, within\n4 mm", ["10 Millimetern", "4 mm"]),
        ("The hand opens 80 mm. Go down 10 mm, auf 10 mm Höhe, at 10 mm/s, within 14 days.", []),
        ("```\nwithin 10 mm\n```\nwithin 9 mm", ["9 mm"]),
        ("A program that takes no longer than 26.5 s, or 27.5 s at most", ["27.5 s"]),
        ("The hand opens at most 80 mm and closes within 0.5 s.", []),
        ("It closes within 0.5 s. A program has to end within 14 s.", ["14 s"]),
        ("stay at most 200 mm above the table; maximal 70 mm, no more than 60 mm", []),
        ("everything lies within 1,000 mm or 1.500 mm of the robot; within 1,5 mm", ["1,5 mm"]),
        ("```within 9 mm```, within 8 mm\n\n```a`\nwithin 7 mm", ["9 mm", "8 mm", "7 mm"]),
        ("<!-- within 9 mm\n\nwithin 8 mm --> within 7 mm", ["7 mm"]),
        ("So:\n\n    within 9 mm\n\n    within 8 mm\nwithin 7 mm", ["7 mm"]),
        ("So\n    within 9 mm\n\n- an item\n\n    within 8 mm", ["9 mm", "8 mm"]),
        ("````\n```\n    ````\nwithin 9 mm\n````\nwithin 8 mm", ["8 mm"]),
    ],
)
def test_words_of_a_teacher_are_held_against_the_task(text: str, told: list[str]) -> None:
    found = [d.primary for d in contradictions(SourceFile("README.md", text), TRUE)]
    assert [label.span.text for label in found if label is not None] == told


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("within 10 mm of the base", ["10 mm"]),
        ("within 10 mm of base2; within 9 mm of it", ["10 mm", "9 mm"]),
        ("The cans stand within 10 mm of their goals.", ["10 mm"]),
        ("Put each **can** there, within 3 mm.", []),
        ("within 10 mm of the gap. Pass within 3 mm of the gap.", ["3 mm"]),
        ("The tool may carry the can, but passes within 10 mm of this point.", []),
        ("You can be within 10 mm of it, or within 3 mm.", []),
    ],
)
def test_a_number_is_held_against_what_its_sentence_names(text: str, told: list[str]) -> None:
    found = [d.primary for d in contradictions(SourceFile("README.md", text), (*TRUE, VIA))]
    assert [label.span.text for label in found if label is not None] == told


def test_the_number_of_a_via_point_does_not_excuse_that_of_a_goal(folder: Path) -> None:
    task = folder / "task.toml"
    via = '[[via]]\nname = "gap"\nat_mm = [900, 0, 100]\nradius_mm = 10\n'
    task.write_text(task.read_text().replace("position_mm = 10", "position_mm = 3") + via)
    text = "# Lab\n\nA can counts within 10 mm of the base.\n\nIt passes the gap within 10 mm.\n"
    text += "\nA program that takes no longer than 26.5 s counts, one of at most 13.25 s more.\n"
    (folder / "README.md").write_text(text)
    assert codes(folder) == [("V684", 0), ("V686", 3)]


def test_a_description_is_held_against_the_task_too(folder: Path) -> None:
    task = folder / "task.toml"
    text = task.read_text().replace("Two cans change", "Within 4 mm two cans change", 2)
    task.write_text(text)
    (folder / "README.md").unlink()
    line = next(n for n, row in enumerate(text.splitlines(), 1) if row.startswith("Within 4 mm"))
    assert codes(folder) == [("V686", line), ("V686", 1)]  # the comment on top says it, too
    assert len(list(said(text))) == 2


@pytest.mark.thorough
def test_check_tells_write_mends_and_pack_writes_anew(folder: Path) -> None:
    task = folder / "task.toml"
    readme = folder / "README.md"
    readme.write_bytes(readme_to_hand_out(folder, load_task(folder)))
    task.write_text(task.read_text().replace("position_mm = 10", "position_mm = 3"))
    readme.write_text(readme.read_text().replace("The end.", "Within 10 mm is enough."))
    before = readme.read_bytes()
    told = vrts_text("task", "check", folder.name, cwd=folder.parent)
    assert told.returncode == 0
    assert told.stderr.count("V684") == 2
    assert "lab/README.md:" in told.stderr
    assert "vrts task check lab --write" in told.stderr
    packed = vrts_text("task", "pack", folder.name, cwd=folder.parent)
    assert packed.returncode == 0, packed.stderr
    assert (packed.stderr.count("V684"), packed.stderr.count("V686")) == (0, 1)
    assert readme.read_bytes() == before
    with zipfile.ZipFile(folder.parent / "lab-student.zip") as archive:
        handed = archive.read("lab/README.md").decode()
    assert handed.count("within 3 mm") == 2
    assert "within 10 mm" not in handed
    mended = vrts_text("task", "check", folder.name, "--write", cwd=folder.parent)
    assert (mended.stderr.count("V684"), mended.stderr.count("V686")) == (0, 1)
    assert readme.read_text() == handed


def test_ten_thousands_of_contradictions_are_told_shortly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "lab"
    shutil.copytree(ROOT / "examples" / "01-cans-on-bases", folder)
    page = (folder / "README.md").read_text()
    (folder / "README.md").write_text((page + "Set it within 11 mm, please.\n" * 40_000)[:999_000])
    made: list[Diagnostic] = []

    def counted(*words: Any, **more: Any) -> Diagnostic:
        made.append(warning(*words, **more))
        return made[-1]

    monkeypatch.setattr(prose, "warning", counted)
    found = handed_findings(folder, load_task(folder))
    assert len(found) == 21
    assert len(made) == 1020  # of the others none is looked at
    assert found[-1].headline == "there are 1,000 or more numbers like these"


def test_a_page_says_that_more_is_checked_where_it_is(tmp_path: Path) -> None:
    folder = tmp_path / "lab"
    shutil.copytree(ROOT / "examples" / "01-cans-on-bases", folder)
    shutil.rmtree(folder / "staff", ignore_errors=True)
    assert "more checks" not in readme_to_hand_out(folder, load_task(folder)).decode()
    (folder / "staff").mkdir()
    (folder / "staff" / "task.toml").write_text(
        '[[via]]\nname = "high above"\nat_mm = [900, 0, 317]\nradius_mm = 291\n'
    )
    assert "marking has more checks" in readme_to_hand_out(folder, load_task(folder)).decode()
    found = handed_findings(folder, load_task(folder))
    assert any("does not say: - marking has" in d.headline for d in found)


def test_comments_that_students_read_are_held_against_the_task(tmp_path: Path) -> None:
    folder = tmp_path / "lab"
    shutil.copytree(ROOT / "examples" / "01-cans-on-bases", folder)
    task = (folder / "task.toml").read_text()
    (folder / "task.toml").write_text(task + "\n# Put it within 77 mm, please.\n# within 10 mm\n")
    start = '; the can has to be within 88 mm\n.PROGRAM main\n TYPE "x; within 66 mm"\n.END\n'
    (folder / "start.v2").write_text(start)
    found = [d for d in handed_findings(folder, load_task(folder)) if d.rule.code == "V686"]
    said = [d.headline for d in found]
    assert len(said) == 2, said
    assert "task.toml` says 77 mm" in said[0]
    assert "start.v2` says 88 mm" in said[1]
    span = found[1].primary
    assert span is not None
    assert span.span.source.text == start
