"""What was handed out decides: a task or a list that has changed redraws nobody in silence."""

import hashlib
import hmac
import shutil
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_rows import plain_row
from vrts.assignments.variants.key import NAME, key_of, note_handed, place_of_handed
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.base.workers import Workers
from vrts.check.variants.model import Without
from vrts.cli.main import vrts
from vrts.marking.intake.row import Platform, Row, Student
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry
from vrts.marking.result import OfVariant
from vrts.marking.row import Row as Marked
from vrts.marking.row import Student as Whose
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.variants.class_list import ClassList, Member
from vrts.marking.variants.doubts import doubts_of
from vrts.marking.variants.hand_out import hand_out
from vrts.marking.variants.handed import (
    DRAWN_AGAIN,
    NOT_HANDED,
    Students,
    changed_since,
    check_some_left,
    handed_bytes,
    read_handed,
    record_gone,
    variants_of,
)
from vrts.marking.variants.of_class import MarkerOfClass
from vrts.pipeline.refused import Refused

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
KEY = b"k" * 32


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = Path(shutil.copytree(LAB, tmp_path_factory.mktemp("handed") / "lab1"))
    (found / NAME).write_text(f"{KEY.hex()}\n")
    return found


@pytest.fixture(scope="module")
def varied(lab: Path) -> VariedTask:
    return load_varied(lab)


def members(*numbers: str, domain: str = "b.c") -> ClassList:
    found = (Member(n, Student(f"N {n}", f"{n}@{domain}"), f"{n}@{domain}") for n in numbers)
    return ClassList(Platform.MOODLE, tuple(found))


def written(varied: VariedTask, place: Path, who: ClassList) -> Students:
    given = variants_of(varied, who, KEY, {})
    place_of_handed(place).write_bytes(handed_bytes(place, KEY, varied, who, given))
    return read_handed(place, KEY, varied.variants.assignment)


def changed(varied: VariedTask, **changes: Any) -> VariedTask:
    return replace(varied, variants=replace(varied.variants, **changes))


def test_what_was_handed_out_stays_whatever_the_draw_goes_by(
    varied: VariedTask, tmp_path: Path
) -> None:
    who = members("1", "2", "3")
    place = tmp_path / NAME
    handed = written(varied, place, who)
    before = variants_of(varied, who, KEY, handed)
    assert before.doubts == {}
    values = {n: varied.variants.values(v.combination) for n, v in before.variants.items()}
    first = varied.variants.varies[0]
    more = first._replace(choices=(("1",), *first.choices))
    excluded = Without({0: frozenset({before.variants["1"].combination[0]})})
    for other, asked in (
        (varied, members("1", "2", "3", domain="changed")),
        (changed(varied, varies=(more, *varied.variants.varies[1:])), who),
        (changed(varied, varies=varied.variants.varies[::-1]), who),
        (changed(varied, without=(excluded,)), who),
    ):
        found = variants_of(other, asked, KEY, handed)
        assert (found.doubts, found.gone) == ({}, ())
        tags = {n: v.tag for n, v in found.variants.items()}
        assert tags == {n: v.tag for n, v in before.variants.items()}
        assert {
            n: other.variants.values(v.combination) for n, v in found.variants.items()
        } == values
        anew = variants_of(other, asked, KEY, {})  # without the record somebody gets another one
        assert anew.variants != found.variants


def test_what_is_gone_or_was_handed_to_nobody_is_doubtful_and_a_new_task_is_refused(
    varied: VariedTask, tmp_path: Path
) -> None:
    who = members("1", "2", "3")
    place = tmp_path / NAME
    handed = written(varied, place, who)
    late = variants_of(varied, members("1", "9"), KEY, handed)
    assert late.doubts == {"9": NOT_HANDED}
    gone = handed["moodle 1"].values["can1_x"]
    first = varied.variants.varies[0]
    fewer = first._replace(choices=tuple(c for c in first.choices if c != gone))
    found = variants_of(
        changed(varied, varies=(fewer, *varied.variants.varies[1:])), who, KEY, handed
    )
    assert "1" in found.doubts
    assert f"`{handed['moodle 1'].tag}` was handed out" in found.doubts["1"]
    check_some_left(late, place)
    renamed = first._replace(name="other")
    none = variants_of(
        changed(varied, varies=(renamed, *varied.variants.varies[1:])), who, KEY, handed
    )
    with pytest.raises(Refused) as refused:
        check_some_left(none, place)
    assert "what was handed out to `N 1`, `N 2`" in refused.value.diagnostics[0].headline


def test_a_task_that_says_something_else_than_was_handed_out_is_told(
    lab: Path, varied: VariedTask, tmp_path: Path
) -> None:
    place, own = tmp_path / NAME, tmp_path / "lab1"
    written(varied, place, members("1", "2"))
    shutil.copytree(lab, own)

    def told() -> list[str]:
        return [d.headline for d in changed_since(place, KEY, load_varied(own))]

    task, scene = own / "task.toml", own / "scene.toml"
    was = task.read_text()
    task.write_text(f"# for those who come late\n{was}".replace("from = 720", "from = 690"))
    assert told() == []  # a comment, and `[variants]`
    task.write_text(was.replace("position_mm = 5", "position_mm = 3"))
    assert told() == ["`task.toml` is another than when variants were handed out"]
    task.write_text(was)
    scene.write_text(scene.read_text().replace('color = "steel"', 'color = "red"'))
    assert told() == ["`scene.toml` is another than when variants were handed out"]
    later = load_varied(own)
    written(later, place, members("1", "2", "3"))  # what the first ones were told stays
    assert told()
    data = place_of_handed(place).read_bytes()
    place_of_handed(place).write_bytes(data.replace(b'"scene.toml"', b'"scene"'))
    with pytest.raises(Refused):
        changed_since(place, KEY, later)


def test_a_record_of_an_earlier_vrts_is_read(varied: VariedTask, tmp_path: Path) -> None:
    place = tmp_path / NAME
    handed = written(varied, place, members("1"))
    tasks = {varied.variants.assignment: handed}
    sealed = hmac.new(KEY, msgspec.json.encode(tasks, order="sorted"), hashlib.sha256).hexdigest()
    record = {"format": "vrts.handed/1", "tasks": tasks, "seal": sealed}
    place_of_handed(place).write_bytes(msgspec.json.encode(record))
    assert read_handed(place, KEY, varied.variants.assignment) == handed
    assert changed_since(place, KEY, varied) == ()


def test_what_is_written_down_is_sealed(varied: VariedTask, tmp_path: Path) -> None:
    place = tmp_path / NAME
    handed = written(varied, place, members("1", "2"))
    path = place_of_handed(place)
    data, tags = path.read_bytes(), [handed[f"moodle {n}"].tag for n in (1, 2)]
    for wrong, key in (
        (data.replace(tags[0].encode(), tags[1].encode()), KEY),
        (data, b"j" * 32),
        (b"{}", KEY),
        (b"\xff", KEY),
    ):
        path.write_bytes(wrong)
        with pytest.raises(Refused) as refused:
            read_handed(place, key, "own-numbers")
        assert "was changed, or belongs to another key" in refused.value.diagnostics[0].headline
    path.write_bytes(data)
    with pytest.raises(Refused) as refused:
        read_handed(place, KEY, "another")
    assert "variants were handed out for `own-numbers`" in refused.value.diagnostics[0].headline


def marker_of(lab: Path, *numbers: str) -> MarkerOfClass:
    return MarkerOfClass(Place(str(lab)), Wanted(), members(*numbers), lab / NAME)


def row(number: str) -> Row:
    return Row(f"s{number}", Student("", ids={"moodle": number}), "a.v2", "")


def test_a_key_without_its_record_is_told_and_makes_every_mark_doubtful(
    varied: VariedTask, lab: Path, tmp_path: Path
) -> None:
    who, name = members("1", "2"), varied.variants.assignment
    place, copy = tmp_path / NAME, tmp_path / "copy" / "lab.key"
    copy.parent.mkdir()
    for text in (KEY.hex(), f"{KEY.hex()}\n"):  # keys of an earlier vrts tell nothing
        place.write_text(text)
        assert record_gone(place, name, {}) == ()
        note_handed(place, name)
        note_handed(place, name)
        assert place.read_text().startswith(f"{KEY.hex()}\nhanded ")
        assert len(place.read_text().splitlines()) == 2
        assert key_of(place) == KEY
    handed = written(varied, place, who)
    assert record_gone(place, name, handed) == ()
    assert record_gone(place, "another", {}) == ()
    shutil.copy(place, copy)
    marker = MarkerOfClass(Place(str(lab)), Wanted(pages=False), who, copy)
    [found] = [*marker.findings]
    assert found.rule.code == "V779"
    assert "`lab.key.handed.json`" in found.help[0]
    marker.assign([row("1"), row("2")], tmp_path / "variants")
    assert marker.doubtful == {"s1": DRAWN_AGAIN, "s2": DRAWN_AGAIN}
    shutil.copy(place_of_handed(place), place_of_handed(copy))
    marker = MarkerOfClass(Place(str(lab)), Wanted(pages=False), who, copy)
    assert (marker.findings, marker.doubtful) == ((), {})


def test_marking_some_again_leaves_what_the_others_were_marked_by(
    lab: Path, tmp_path: Path
) -> None:
    marker = marker_of(lab, "1", "2")
    tags = {member.number: tag for tag, who in marker.owners.items() for member in who}
    for name in ("gone", tags["2"]):
        (tmp_path / f"{name}.zip").write_bytes(b"as it was")
    marker.assign([row("1")], tmp_path, some=True)
    assert {path.stem for path in tmp_path.glob("*.zip")} == {"gone", *tags.values()}
    assert (tmp_path / f"{tags['2']}.zip").read_bytes() == b"as it was"
    assert zipfile.is_zipfile(tmp_path / f"{tags['1']}.zip")
    assert set(marker.places) == {tags["1"]}
    marker.assign([row("1"), row("2")], tmp_path)
    assert {path.stem for path in tmp_path.glob("*.zip")} == set(tags.values())


def test_who_has_another_variant_now_is_not_marked_again_alone(lab: Path, tmp_path: Path) -> None:
    marker, layout = marker_of(lab, "1", "2"), Layout(tmp_path)
    rows = [row("1"), row("2")]
    marker.assign(rows, layout.variants)

    def marked(tag: str) -> Marked:
        found = plain_row("s2", variant=OfVariant(tag))
        return msgspec.structs.replace(found, student=Whose(ids={"moodle": "2"}))

    assert marker.is_as_before(marked(marker.tags["s2"]), layout)
    assert not marker.is_as_before(marked(marker.tags["s1"]), layout)


def test_nobodys_variant_is_that_of_a_trial_of_somebody_elses(lab: Path, tmp_path: Path) -> None:
    marker = marker_of(lab, "1", "2")
    mine = replace(row("1"), identifier="other-0")
    marker.assign([mine, row("2")], tmp_path)
    own, other = marker.tags["other-0"], marker.tags["s2"]
    program = f"; variant {own}\n.PROGRAM main()\n.END\n".encode()
    entries = [
        Entry("other-0", "a.v2", program),
        Entry("s2", "a.v2", program),
    ]
    asked: list[str] = []

    def mark(few: Any) -> list[Done]:
        asked.extend(marker.tags[entry.identifier] for entry in few)
        return []

    doubts = doubts_of(marker, entries, mark)
    assert (asked, list(doubts)) == ([own], ["s2"])
    assert marker.tags["other-0"] == own
    # the other way round, too: whoever is called so keeps the own variant
    entries = [Entry("other-0", "a.v2", f"; variant {other}\n".encode() + program)]
    doubts_of(marker, entries, mark)
    assert marker.tags["other-0"] == own


def test_zips_of_long_names_do_not_collide(varied: VariedTask) -> None:
    long = "A" * 120
    both = tuple(Member(n, Student(long), n) for n in ("1001", "1002"))
    who = ClassList(Platform.CANVAS, both)
    given = variants_of(varied, who, KEY, {})
    files = hand_out(varied, who, given.variants).files
    assert [name[-9:] for name in files] == ["_1001.zip", "_1002.zip"]
    alike = ClassList(Platform.CANVAS, tuple(both[0]._replace(number=n) for n in ("1", "1?")))
    with pytest.raises(Refused) as refused:
        hand_out(varied, alike, variants_of(varied, alike, KEY, {}).variants)
    assert "would have the zip" in refused.value.diagnostics[0].headline


def test_zips_are_the_same_whoever_writes_them(varied: VariedTask) -> None:
    who = ClassList(Platform.CANVAS, tuple(Member(n, Student(n), n) for n in ("1", "2", "3")))
    variants = variants_of(varied, who, KEY, {}).variants
    steps: list[tuple[int, int]] = []
    two = hand_out(varied, who, variants, (), Workers(2), lambda done, of: steps.append((done, of)))
    assert two == hand_out(varied, who, variants)
    different = len({one.tag for one in variants.values()})
    assert steps == [(k, different) for k in range(1, different + 1)]


def call(*words: object) -> Any:
    return CliRunner().invoke(vrts, [str(word) for word in words])


@pytest.mark.thorough
def test_variants_that_fall_out_and_zips_of_others_are_not_handed_out(tmp_path: Path) -> None:
    lab = Path(shutil.copytree(LAB, tmp_path / "lab1"))
    roster = tmp_path / "grades.csv"
    head = "Identifier,Full name,Email address,Status\n"
    roster.write_text(f"{head}Participant 7,Ada,a@b.c,No submission\n")
    text = (lab / "task.toml").read_text()
    uneven = text.replace("from = 720", "from = 600", 1).replace("to = 840", "to = 1080", 1)
    uneven = uneven.replace("step = 30", "step = 480", 1)
    uneven = uneven.partition('[[variants.vary]]\nname = "can1_y"')[0]  # two variants are left
    (lab / "task.toml").write_text(f"{uneven}[variants.even]\ntime = 0.01\n")
    words = ("task", "variants", lab, "--roster", roster, "-o", tmp_path / "zips")
    told = call(*words, "--jobs", 1)
    assert told.exit_code == 1, told.output
    assert "not all variants are fit to be handed out" in told.output
    assert not (tmp_path / "zips").exists()
    assert not place_of_handed(lab / NAME).exists()
    (lab / "task.toml").write_text(text)
    assert call(*words, "--untried").exit_code == 0
    assert place_of_handed(lab / NAME).stat().st_mode & 0o777 == 0o600
    assert len(key_of(lab / NAME)) == 32
    roster.write_text(f"{head}Participant 8,Kurt,k@b.c,No submission\n")
    told = call(*words, "--untried")
    assert told.exit_code == 2
    assert "has zips of nobody in the list: `Ada_7.zip`" in told.output
