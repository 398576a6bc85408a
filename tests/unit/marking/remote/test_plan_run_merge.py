"""Shards that name nobody go out; what comes back is what marking here would have written."""

import io
import json
import stat
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import msgspec
import pytest

from tests.unit.marking.remote.support import CLASS, NAMES, files, task
from vrts.base.diagnostic import Diagnostic
from vrts.marking.layout import Layout
from vrts.marking.marking import mark_class
from vrts.marking.remote.merge import Merged, merge
from vrts.marking.remote.plan import make_plan, read_key, write_plan
from vrts.marking.remote.run_shard import run_shard
from vrts.marking.remote.shard import digest_of, read_shard
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.limits import Limits
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.refused import Refused


class Sent(NamedTuple):
    """A class that was planned, and its shards marked."""

    marker: Marker
    plan: Path
    shards: list[Path]
    results: list[Path]

    def merge(self, out: Path, *results: Path) -> Merged:
        """Merge some results."""
        return merge(read_key(self.plan), results, Layout(out))


@pytest.fixture(scope="module")
def sent(tmp_path_factory: pytest.TempPathFactory) -> Sent:
    """Return the class in two shards, with pages and results."""
    home = tmp_path_factory.mktemp("sent")
    marker = Marker(Place(task(home / "lab one")), Wanted())
    shards = write_plan(make_plan(marker, CLASS, 2), home / "plan")
    results: list[Path] = []
    for path in shards:
        data = path.read_bytes()
        results.append(home / f"{path.stem}.zip")
        results[-1].write_bytes(run_shard(read_shard(data), data, home / "work" / path.stem))
    return Sent(marker, home / "plan", shards, results)


def codes(found: tuple[Diagnostic, ...]) -> list[str]:
    return [d.rule.code for d in found]


def test_merged_results_and_pages_are_those_of_marking_here(sent: Sent, tmp_path: Path) -> None:
    list(mark_class(sent.marker, CLASS, Layout(tmp_path / "here"), jobs=2))
    merged = sent.merge(tmp_path / "there", *sent.results)
    assert merged.findings == ()
    assert merged.missing == ()
    here, there = files(tmp_path / "here"), files(tmp_path / "there")
    assert len(here) == 26, "two results each, two pages where there was a file"
    assert there.keys() == here.keys()
    assert [name for name in here if here[name] != there[name]] == []
    assert any("letter.v2`" in text.decode() for text in there.values()), "a sentence has a title"
    again = list(mark_class(sent.marker, CLASS, Layout(tmp_path / "there")))
    assert {done.entry.identifier for done in again if not done.reused} == {"dora", "gina"}


def test_nothing_that_leaves_names_anybody_or_this_machine(sent: Sent) -> None:
    for path in (*sent.shards, *sent.results):
        texts = [path.name.encode(), path.read_bytes()]
        if zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                texts += [name.encode() for name in archive.namelist()]
                texts += [archive.read(name) for name in archive.namelist()]
        for text in texts:
            found = [name for name in NAMES if name.encode() in text]
            found += [name for name in NAMES if json.dumps(name)[1:-1].encode() in text]
            assert found == []
            assert str(sent.plan.parent).encode() not in text


def test_files_of_a_plan_are_for_their_owner_only(sent: Sent) -> None:
    for path in (sent.plan / "key.json", *sent.shards):
        assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert [path.name for path in sent.shards] == ["shard-01.json", "shard-02.json"]


def test_merging_in_parts_and_twice_changes_nothing(sent: Sent, tmp_path: Path) -> None:
    first = sent.merge(tmp_path, sent.results[1])
    assert codes(first.findings) == ["V726"]
    assert first.missing == ("Ünal-Ayşe_471108150815", "smith-ben")
    (incomplete,) = first.findings
    assert incomplete.headline == "2 of 5 submissions have no result yet"
    assert incomplete.notes[1] == "they are in shard 1"
    assert sent.merge(tmp_path, sent.results[0]).missing == ()
    before = files(tmp_path)
    assert sent.merge(tmp_path, *sent.results, sent.results[0]).findings == ()
    assert files(tmp_path) == before


def test_a_lost_result_never_takes_the_place_of_a_mark(sent: Sent, tmp_path: Path) -> None:
    limits = Limits(wall_s=0.01)
    plan = make_plan(sent.marker, CLASS[:1], 1, limits)
    (path,) = write_plan(plan, tmp_path / "plan")
    data = path.read_bytes()
    lost = tmp_path / "lost.zip"
    lost.write_bytes(run_shard(read_shard(data), data, tmp_path / "work"))
    out = tmp_path / "out"
    (row,) = merge(read_key(tmp_path / "plan"), [lost], Layout(out)).rows
    assert (row.marks.staff.kind, row.marks.staff.mark) == (Kind.RESOURCE, None)
    place = Layout(out).grader(CLASS[0].identifier) / "lost.txt"
    assert "did not end in time" in place.read_text()
    sent.merge(out, *sent.results)
    assert not place.exists()
    before = files(out)
    merge(read_key(tmp_path / "plan"), [lost], Layout(out))
    assert files(out) == before


def test_an_interrupted_shard_goes_on_where_it_was(sent: Sent, tmp_path: Path) -> None:
    data = sent.shards[0].read_bytes()
    shard = read_shard(data)
    part = msgspec.structs.replace(shard, pieces=shard.pieces[:1])
    run_shard(part, data, tmp_path)
    reused: list[bool] = []
    run_shard(shard, data, tmp_path, done=lambda row: reused.append(row.reused))
    assert reused == [True, False]


def changed(path: Path, target: Path, change: Callable[[dict[str, bytes]], None]) -> Path:
    """Write a zip in which members were changed."""
    with zipfile.ZipFile(path) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    change(members)
    with zipfile.ZipFile(target, "w") as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return target


def change_key(members: dict[str, bytes]) -> None:
    name = next(name for name in members if name.endswith("staff/result.json"))
    result = json.loads(members[name])
    members[name] = json.dumps(result | {"key": "0" * 64}).encode()


def drop_a_result(members: dict[str, bytes]) -> None:
    del members[next(name for name in members if name.endswith("student/result.json"))]


def drop_a_row(members: dict[str, bytes]) -> None:
    contents = json.loads(members["marked.json"])
    gone = contents["rows"].pop()["pseudonym"]
    for name in [name for name in members if name.startswith(gone)]:
        del members[name]
    members["marked.json"] = json.dumps(contents).encode()


def swap_results(members: dict[str, bytes]) -> None:
    first, second = [name for name in members if name.endswith("staff/result.json")]
    members[first], members[second] = members[second], members[first]


def escape(members: dict[str, bytes]) -> None:
    members["../../evil.html"] = b"<script>alert(1)</script>"


def add_a_program(members: dict[str, bytes]) -> None:
    row = json.loads(members["marked.json"])["rows"][0]["pseudonym"]
    members[f"{row}/student/evil.exe"] = b"MZ"


def spoil_contents(members: dict[str, bytes]) -> None:
    members["marked.json"] = members["marked.json"].replace(b"vrts.marked/1", b"vrts.marked/9")


def clear(members: dict[str, bytes]) -> None:
    members.clear()


def change_shard(members: dict[str, bytes]) -> None:
    contents = json.loads(members["marked.json"])
    members["marked.json"] = json.dumps(contents | {"shard": "0" * 64}).encode()


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (change_key, "V725"),
        (drop_a_result, "V722"),
        (drop_a_row, "V725"),
        (swap_results, "V725"),
        (escape, "V722"),
        (add_a_program, "V722"),
        (spoil_contents, "V722"),
        (change_shard, "V724"),
        (clear, "V722"),
    ],
    ids=lambda value: getattr(value, "__name__", value),
)
def test_what_was_changed_is_refused_and_the_rest_taken(
    change: Callable[[dict[str, bytes]], None], code: str, sent: Sent, tmp_path: Path
) -> None:
    bad = changed(sent.results[0], tmp_path / "bad.zip", change)
    merged = sent.merge(tmp_path / "out", bad, sent.results[1])
    assert codes(merged.findings) == [code, "V726"]
    assert "`bad.zip`" in merged.findings[0].headline
    assert len(merged.rows) == 3
    assert not (tmp_path / "evil.html").exists()


def test_damage_is_refused(sent: Sent, tmp_path: Path) -> None:
    whole = sent.results[0].read_bytes()
    with zipfile.ZipFile(sent.results[0]) as archive:
        page = next(i for i in archive.infolist() if i.filename.endswith("staff/report.html"))
    flipped = bytearray(whole)
    flipped[page.header_offset + 200] ^= 0xFF
    for data in (b"", b"PK\x03\x04 and nothing", whole[: len(whole) // 2], bytes(flipped)):
        path = tmp_path / "bad.zip"
        path.write_bytes(data)
        assert codes(sent.merge(tmp_path / "out", path).findings)[0] == "V722"


def test_results_of_another_plan_are_foreign(sent: Sent, tmp_path: Path) -> None:
    write_plan(make_plan(sent.marker, CLASS, 2), tmp_path / "plan")
    found = merge(read_key(tmp_path / "plan"), sent.results, Layout(tmp_path / "out"))
    assert codes(found.findings) == ["V724", "V724", "V726"]
    assert found.rows == ()


def refusal(data: bytes) -> str:
    with pytest.raises(Refused) as refused:
        read_shard(data)
    (finding,) = refused.value.diagnostics
    return finding.rule.code


def test_what_is_no_shard_is_refused(sent: Sent) -> None:
    good = sent.shards[0].read_bytes()
    shard = json.loads(good)
    twice = shard | {"pieces": [shard["pieces"][0]] * 2}
    evil = shard | {"pieces": [shard["pieces"][0] | {"pseudonym": "../../evil"}]}
    for changed_shard in (twice, evil, shard | {"schema": "vrts.shard/2"}, shard | {"more": 1}):
        assert refusal(json.dumps(changed_shard).encode()) == "V720"
    assert refusal(b"[]") == "V720"
    assert refusal(good[: len(good) // 2]) == "V720"
    assert refusal(b"") == "V720"
    assert refusal(json.dumps(shard | {"vrts": "9.9.9"}).encode()) == "V721"


def test_what_is_no_key_is_refused(sent: Sent) -> None:
    with pytest.raises(Refused) as refused:
        read_key(sent.shards[0])
    assert codes(refused.value.diagnostics) == ["V723"]


def test_a_shard_brings_scene_scenario_and_lab_along(tmp_path: Path) -> None:
    example = CHECKOUT / "examples" / "01-cans-on-bases"
    other = tmp_path / "moved" / "scene.toml"
    other.parent.mkdir()
    scene = (CHECKOUT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
    other.write_text(scene.replace("[800, -450]", "[810, -450]"))
    scenario = tmp_path / "late.toml"
    scenario.write_text("[limits]\ntime_s = 3\n")
    place = Place(str(example / "task.toml"), str(other), str(scenario))
    marker = Marker(place, Wanted(pages=False))
    (here,) = mark_class(marker, CLASS[:1], None, staging=tmp_path / "staging")
    (path,) = write_plan(make_plan(marker, CLASS[:1], 3), tmp_path / "plan")
    data = path.read_bytes()
    for file in (other, scenario):
        file.unlink()
    result = tmp_path / "result.zip"
    result.write_bytes(run_shard(read_shard(data), data, tmp_path / "work"))
    (row,) = merge(read_key(tmp_path / "plan"), [result], Layout(tmp_path / "out")).rows
    assert row.marks.staff == here.result
    assert row.marks.staff.stamps == ("modified scene: this mark does not count",)


def test_the_same_shard_gives_the_same_results(sent: Sent, tmp_path: Path) -> None:
    data = sent.shards[1].read_bytes()
    again = run_shard(read_shard(data), data, tmp_path, jobs=2)
    with (
        zipfile.ZipFile(io.BytesIO(again)) as one,
        zipfile.ZipFile(sent.results[1]) as other,
    ):
        assert one.namelist() == other.namelist()
        same = [n for n in one.namelist() if n != "marked.json" and one.read(n) == other.read(n)]
        assert len(same) == len(one.namelist()) - 1
        assert json.loads(one.read("marked.json"))["shard"] == digest_of(data)
