"""Pseudonyms: keyed, steady, and the only thing that is told of a person."""

import re
import stat
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from tests.unit.marking.appeals.support import class_of, row
from vrts import __version__
from vrts.marking.about import About
from vrts.marking.class_marks import entries
from vrts.marking.intake.row import Attempt, Kind, Problem, Row, Student
from vrts.marking.intake.take_in import take_in_tree
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.layout import Layout
from vrts.marking.privacy.pseudonyms import (
    KEY,
    NAMES,
    key_for,
    nameless_about,
    names_table,
    pseudonym,
    pseudonymised,
    read_names,
    require_names,
    with_names,
    write_names,
)
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.pipeline.refused import Refused

PROGRAM = b".PROGRAM pick()\nSTOP\n.END\n"
TIME = datetime(2026, 11, 30, 12, tzinfo=UTC)
ANNA = Row(
    "anna-berger-1",
    Student("Berger, Anna", "anna@uni.example", "aberger", {"moodle": "1", "sis": "77"}),
    "anna/berger.v2",
    "the only file that has `.PROGRAM pick`, as `berger-old.v2` does not",
    TIME,
    attempts=(Attempt("anna/berger-old.v2", TIME), Attempt("anna/berger.v2", TIME)),
    others=("anna/berger-old.v2",),
    group="team-berger",
)
BEN = Row(
    "ben-otto",
    Student("Ben Otto"),
    None,
    "",
    problem=Problem(Kind.AMBIGUOUS, "2 files fit, and nothing says which: `otto1.v2`, `otto2.v2`"),
    group="team-berger",
)
SECRETS = ("anna", "berger", "ben", "otto", "moodle", "77")


@pytest.fixture
def layout(tmp_path: Path) -> Layout:
    """Return an empty folder for results."""
    return Layout(tmp_path / "out")


def test_a_pseudonym_is_keyed_and_steady() -> None:
    one = pseudonym("anna", b"k" * 32)
    assert one == "czdb-wlsv-vpxm"
    assert pseudonym("anna", b"l" * 32) != one
    many = {pseudonym(f"student {k}", b"k" * 32) for k in range(2000)}
    assert len(many) == 2000
    assert all(re.fullmatch(r"([b-df-hj-np-tv-xz]{4}-){2}[b-df-hj-np-tv-xz]{4}", p) for p in many)


def test_a_key_is_drawn_once_for_its_owner_only(layout: Layout, tmp_path: Path) -> None:
    key = key_for(layout)
    assert len(key) == 32
    assert key_for(layout) == key
    place = layout.staff / KEY
    assert stat.S_IMODE(place.stat().st_mode) == 0o600
    assert key_for(Layout(tmp_path / "other")) != key
    for spoilt in (b"", b"abc", place.read_bytes().upper()[:-1] + b"G\n", b"0" * 63):
        place.write_bytes(spoilt)
        with pytest.raises(Refused) as refused:
            key_for(layout)
        assert [d.rule.code for d in refused.value.diagnostics] == ["V772"]


def test_a_link_is_no_key(layout: Layout, tmp_path: Path) -> None:
    (tmp_path / "elsewhere").write_text("0" * 64)
    layout.staff.mkdir(parents=True)
    (layout.staff / KEY).symlink_to(tmp_path / "elsewhere")
    with pytest.raises(Refused):
        key_for(layout)
    (layout.staff / KEY).unlink()
    (layout.staff / KEY).symlink_to(tmp_path / "not-there")
    with pytest.raises(Refused):
        key_for(layout)
    assert not (tmp_path / "not-there").exists()


def test_names_and_pseudonyms_do_not_share_a_folder(layout: Layout) -> None:
    require_names(layout)
    layout.staff.mkdir(parents=True)
    layout.results.write_text("{}")
    with pytest.raises(Refused):
        key_for(layout)
    layout.results.unlink()
    layout.student("anna").mkdir(parents=True)
    with pytest.raises(Refused):
        key_for(layout)
    layout.student("anna").rmdir()
    layout.student("anna").parent.rmdir()
    key_for(layout)
    layout.results.write_text("{}")
    layout.student("bcdf-ghjk-lmnp").mkdir(parents=True)
    key_for(layout)
    with pytest.raises(Refused) as refused:
        require_names(layout)
    assert [d.rule.code for d in refused.value.diagnostics] == ["V773"]


def test_nothing_of_a_person_is_left_in_a_row(tmp_path: Path) -> None:
    (tmp_path / "anna").mkdir()
    (tmp_path / "anna" / "berger.v2").write_bytes(PROGRAM)
    with open_place(tmp_path) as tree:
        nameless, (anna, ben) = pseudonymised(tree, (ANNA, BEN), b"k" * 32)
        text = f"{anna} {ben} {nameless.files} {nameless.title}".casefold()
        assert not [secret for secret in SECRETS if secret in text]
        first, second = entries(nameless, (anna, ben))
    assert (anna.received, anna.attempt) == (TIME, 2)
    assert anna.group == ben.group
    assert first.data == PROGRAM
    assert first.title == f"{anna.identifier}.v2"
    assert (second.data, second.kind is None) == (None, False)


def test_files_in_archives_are_found_under_their_other_name(tmp_path: Path) -> None:
    import zipfile

    with zipfile.ZipFile(tmp_path / "work.zip", "w") as archive:
        archive.writestr("berger.VAL", PROGRAM)
    zipped = replace(ANNA, file="work.zip!berger.VAL")
    gone = replace(BEN, file="gone.v2", problem=None)
    with open_place([tmp_path / "work.zip"]) as tree:
        zipped = replace(zipped, file=f"{tree.files[0]}!berger.VAL")
        renamed, rows = pseudonymised(tree, (zipped, gone), b"k" * 32)
        first, second = entries(renamed, rows)
    assert first.data == PROGRAM
    assert first.title.endswith(".val")
    assert second.data is None
    assert "gone" not in second.sentence


def test_an_ending_that_is_no_language_is_left_out(tmp_path: Path) -> None:
    with open_place(tmp_path) as tree:
        _, (anna,) = pseudonymised(tree, (replace(ANNA, file="x.berger"),), b"k" * 32)
    assert anna.file == anna.identifier


def test_who_is_who_stands_in_one_table(layout: Layout) -> None:
    key = key_for(layout)
    multiline = replace(BEN, others=("otto1.v2", "otto2.v2"), student=Student("=Ben\nOtto"))
    write_names(layout.staff, names_table((ANNA, multiline), key))
    place = layout.staff / NAMES
    assert stat.S_IMODE(place.stat().st_mode) == 0o600
    names = read_names(layout)
    assert names[pseudonym("anna-berger-1", key)]["file"] == "anna/berger.v2"
    assert names[pseudonym("ben-otto", key)]["others"] == "otto1.v2\notto2.v2"
    rows = class_of(row(pseudonym("anna-berger-1", key)), row("somebody-else"))
    anna, other = with_names(rows, layout).rows
    assert anna.student.name == "Berger, Anna"
    assert (anna.student.email, anna.student.login) == ("anna@uni.example", "aberger")
    assert anna.student.ids == {"moodle": "1", "sis": "77"}
    assert anna.id == pseudonym("anna-berger-1", key)
    assert other == rows.rows[1]
    assert with_names(rows, Layout(layout.root / "nowhere")) == rows


def test_the_same_table_is_read_as_a_table_of_hand_ins(layout: Layout, tmp_path: Path) -> None:
    from vrts.marking.intake.tables.edited_table import read_rows

    download = tmp_path / "download" / "anna"
    download.mkdir(parents=True)
    (download / "berger.v2").write_bytes(PROGRAM)
    with open_place(tmp_path / "download") as tree:
        intake = take_in_tree(tree, program=None)
        write_names(layout.staff, names_table(intake.rows, key_for(layout)))
        data = (layout.staff / NAMES).read_bytes()
        assert read_rows(data, NAMES, tree, intake).rows == intake.rows


def test_a_marking_does_not_tell_files_that_were_named(tmp_path: Path) -> None:
    (tmp_path / "download").mkdir()
    folder, file = str(tmp_path / "download"), str(tmp_path / "anna.v2")
    about = About(
        "vrts.marking/1",
        "Lab 1",
        Place("lab1"),
        (folder, file, "w26.zip"),
        Wanted(),
        __version__,
        ("vrts", "grade", "lab1", folder, file, "w26.zip", "--pseudonyms"),
        TIME,
    )
    told = nameless_about(about)
    assert told.submissions == (folder, "w26.zip")
    assert told.command == ("vrts", "grade", "lab1", folder, "w26.zip", "--pseudonyms")
