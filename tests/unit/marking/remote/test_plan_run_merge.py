"""Shards that name nobody go out; what comes back is what marking here would have written."""

import base64
import io
import json
import os
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
from vrts.marking.remote.marked import Used, is_of, signed_contents
from vrts.marking.remote.merge import Merged, merge
from vrts.marking.remote.plan import make_plan, read_key, write_plan
from vrts.marking.remote.run_shard import run_shard
from vrts.marking.remote.shard import digest_of, read_shard
from vrts.marking.remote.signed import secret_of_shard, signature
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.limits import Limits
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.refused import Refused

FOREIGN = secret_of_shard("ab" * 32, "0" * 16, 2)  # of another shard


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


NO_POINTS = "it holds points that no marking gives"
PARTS = {"targets": 0.0, "vias": 0.0, "contacts": 0.0, "demands": 0.0, "time": 0.0}


def loss(exact: str, points: float = 1.5) -> dict[str, object]:
    """Return a loss of so many points."""
    where = {"hint": None, "line": None, "time_s": None}
    return {"points": points, "points_exact": exact, "kind": "time", "sentence": "slow", **where}


def check(points: float) -> dict[str, object]:
    """Return a check that earned so many points."""
    words = {"id": "a", "title": "a", "kind": "time", "answer": "holds", "message": ""}
    return {**words, "points": points, "most": 1.0, "hidden": False}


def codes(found: tuple[Diagnostic, ...]) -> list[str]:
    return [d.rule.code for d in found]


@pytest.mark.thorough
def test_merged_results_and_pages_are_those_of_marking_here(sent: Sent, tmp_path: Path) -> None:
    list(mark_class(sent.marker, CLASS, Layout(tmp_path / "here"), jobs=2))
    merged = sent.merge(tmp_path / "there", *sent.results)
    assert merged.findings == ()
    assert merged.missing == ()
    here, there = files(tmp_path / "here"), files(tmp_path / "there")
    assert len(here) == 28, "two results each, two pages where there was a file, motion of runs"
    assert there.keys() == here.keys()
    assert [name for name in here if here[name] != there[name]] == []
    assert any("letter.v2`" in text.decode() for text in there.values()), "a sentence has a title"
    again = list(mark_class(sent.marker, CLASS, Layout(tmp_path / "there")))
    assert {done.entry.identifier for done in again if not done.reused} == {"dora", "gina"}


def readable(data: bytes) -> list[bytes]:
    """Return all that can be read in a file: packed, or as base64, letters mean nothing."""
    if zipfile.is_zipfile(io.BytesIO(data)):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            names = archive.namelist()
            return [archive.comment, *map(str.encode, names), *map(archive.read, names)]
    shard = json.loads(data)
    held = [shard["task"].pop("packed"), *(piece.pop("program") for piece in shard["pieces"])]
    found = [json.dumps(shard).encode(), json.dumps(shard, ensure_ascii=False).encode()]
    for text in map(base64.b64decode, held):
        found += readable(text) if zipfile.is_zipfile(io.BytesIO(text)) else [text]
    return found


@pytest.mark.thorough
def test_nothing_that_leaves_names_anybody_or_this_machine(sent: Sent) -> None:
    for path in (*sent.shards, *sent.results):
        for text in (path.name.encode(), *readable(path.read_bytes())):
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


@pytest.mark.thorough
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


def pseudonym(sent: Sent, identifier: str) -> str:
    """Return what a submission is called in its shard."""
    entries = [entry for shard in read_key(sent.plan).shards for entry in shard.entries]
    return next(e.naming.pseudonym for e in entries if e.naming.identifier == identifier)


def lied(sent: Sent, target: Path, change: Callable[[dict[str, bytes]], None]) -> Path:
    """Write a zip as a machine can make it that has the first shard, and lies."""
    shard = read_shard(sent.shards[0].read_bytes())
    digest = digest_of(sent.shards[0].read_bytes())

    def sign(members: dict[str, bytes]) -> None:
        del members["marked.json"], members["signature.txt"]
        change(members)
        files: dict[str, dict[str, str]] = {}
        for name, data in members.items():
            whose, _, file = name.partition("/")
            files.setdefault(whose, {})[file] = digest_of(data)
        members |= signed_contents(shard, digest, [Used(n, 1.0, 1, f) for n, f in files.items()])

    return changed(sent.results[0], target, sign)


def change_mark(members: dict[str, bytes]) -> None:
    name = next(name for name in members if name.endswith("staff/result.json"))
    members[name] = json.dumps(json.loads(members[name]) | {"mark": 9.9}).encode()


def change_page(members: dict[str, bytes]) -> None:
    name = next(name for name in members if name.endswith("student/report.html"))
    members[name] += b"<script>alert(1)</script>"


def drop_a_page(members: dict[str, bytes]) -> None:
    del members[next(name for name in members if name.endswith("staff/report.html"))]


def change_contents(members: dict[str, bytes]) -> None:
    """Change a mark, and its digest in the table of contents."""
    name = next(name for name in members if name.endswith("staff/result.json"))
    before = digest_of(members[name])
    change_mark(members)
    after = digest_of(members[name])
    members["marked.json"] = members["marked.json"].replace(before.encode(), after.encode())


def drop_the_signature(members: dict[str, bytes]) -> None:
    del members["signature.txt"]


def forge_as_another_shard(members: dict[str, bytes]) -> None:
    """Sign with the secret of another shard of the same plan."""
    change_contents(members)
    members["signature.txt"] = signature(FOREIGN, members["marked.json"]).encode()


def unsign(members: dict[str, bytes]) -> None:
    """Pretend to be of an earlier vrts."""
    contents = json.loads(members["marked.json"]) | {"schema": "vrts.marked/1"}
    for row in contents["rows"]:
        del row["files"]
    members["marked.json"] = json.dumps(contents).encode()
    del members["signature.txt"]
    change_mark(members)


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
    members["marked.json"] = members["marked.json"].replace(b"vrts.marked/2", b"vrts.marked/9")


def clear(members: dict[str, bytes]) -> None:
    members.clear()


def change_shard(members: dict[str, bytes]) -> None:
    contents = json.loads(members["marked.json"])
    members["marked.json"] = json.dumps(contents | {"shard": "0" * 64}).encode()


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (drop_a_row, "V730"),
        (change_contents, "V730"),
        (drop_the_signature, "V730"),
        (forge_as_another_shard, "V730"),
        (unsign, "V730"),
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


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (change_mark, "`{0}/staff/result.json` was changed after it was signed"),
        (change_page, "`{0}/student/report.html` was changed after it was signed"),
        (swap_results, "`{0}/staff/result.json` was changed after it was signed"),
        (drop_a_result, "`{0}/student/result.json` is missing in it"),
        (drop_a_page, "`{0}/staff/report.html` is not what was signed"),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_a_result_changed_on_the_way_is_named_and_the_others_taken(
    change: Callable[[dict[str, bytes]], None], why: str, sent: Sent, tmp_path: Path
) -> None:
    bad = changed(sent.results[0], tmp_path / "bad.zip", change)
    merged = sent.merge(tmp_path / "out", bad, sent.results[1])
    count = 2 if change is swap_results else 1
    assert codes(merged.findings) == ["V725"] * count + ["V726"]
    naming = read_key(sent.plan).shards[0].entries[0].naming
    first = merged.findings[0]
    said = why.format(naming.pseudonym)
    assert first.headline == (
        f"`bad.zip`, shard 1: the result of `{naming.identifier}` is not taken: {said}"
    )
    assert first.help == (
        "delete `bad.zip` and run shard 1 again on a machine that you trust, and merge again",
    )
    assert len(merged.rows) == 5 - count
    assert not Layout(tmp_path / "out").grader(naming.identifier).exists()
    assert sent.merge(tmp_path / "out", sent.results[0]).missing == ()


@pytest.mark.parametrize(
    ("lie", "why"),
    [
        ({"mark": 10.0}, "its mark is 10, and its parts give 4.5"),
        ({"mark": None}, "it says `graded`, and has no mark"),
        ({"parts": None}, "it says `graded`, and has no parts"),
        ({"losses": []}, "its mark is 4.5 of 10, and its causes cost 0"),
        ({"checks": []}, "its mark is 4.5, and its checks earned 0"),
        ({"lowest": 7.5}, "its mark is 4.5, and cannot be lower than 7.5"),
        ({"kind": "excused"}, "it says `excused`, and a program was sent"),
        ({"kind": "fault"}, "it says `fault`, and has a mark"),
        ({"total": 20.0}, "it is out of 20 points, and the task of 10"),
        ({"key": "0" * 64}, "it was made with another vrts, or with other options"),
        ({"id": "s" + "0" * 12}, "it is of another submission"),
        ({"program": None}, "it does not tell of which program it is"),
        ({"losses": [loss("1/0")]}, NO_POINTS),
        ({"losses": [loss("9" * 5000)]}, NO_POINTS),
        ({"losses": [loss("1/" + "7" * 5000)]}, NO_POINTS),
        ({"losses": [loss("1/3")]}, NO_POINTS),
        ({"losses": [loss("3/2", 1e308)]}, NO_POINTS),
        ({"checks": [check(1e308), check(1e308)]}, NO_POINTS),
        ({"parts": {**PARTS, "targets": 1e308, "vias": 1e308}}, NO_POINTS),
        ({"parts": {**PARTS, "targets": 1e308, "contacts": -1e308}}, NO_POINTS),
        ({"kind": "unreadable", "mark": 0.0, "parts": None, "losses": [loss("1/0")]}, NO_POINTS),
        ({"program": {"name": "x.v2", "sha256": "0" * 64, "size": 3}}, "it is of another program"),
    ],
    ids=lambda value: str(value)[:60],
)
def test_a_signed_lie_is_found_where_home_can_tell(
    lie: dict[str, object], why: str, sent: Sent, tmp_path: Path
) -> None:
    def tell(members: dict[str, bytes]) -> None:
        name = f"{pseudonym(sent, 'smith-ben')}/staff/result.json"
        members[name] = json.dumps(json.loads(members[name]) | lie).encode()

    bad = lied(sent, tmp_path / "bad.zip", tell)
    merged = sent.merge(tmp_path / "out", bad, sent.results[1])
    assert codes(merged.findings) == ["V725", "V726"]
    assert merged.findings[0].headline == (
        f"`bad.zip`, shard 1: the result of `smith-ben` is not taken: {why}"
    )
    assert merged.missing == ("smith-ben",)


NO_TEXT = b'"\xff"'  # in JSON, a string that is none


def spoil_text(members: dict[str, bytes]) -> None:
    members["marked.json"] = members["marked.json"].replace(b'"vrts.marked/2"', NO_TEXT)


def test_bytes_that_are_no_text_are_refused_everywhere(sent: Sent, tmp_path: Path) -> None:
    bad = changed(sent.results[0], tmp_path / "bad.zip", spoil_text)
    assert codes(sent.merge(tmp_path / "out", bad, sent.results[1]).findings) == ["V722", "V726"]

    def spoil(members: dict[str, bytes]) -> None:
        name = f"{pseudonym(sent, 'smith-ben')}/staff/result.json"
        members[name] = members[name].replace(b'"graded"', NO_TEXT)

    (first, _) = sent.merge(tmp_path / "other", lied(sent, tmp_path / "lie.zip", spoil)).findings
    assert first.headline.endswith("staff/result.json` is no result")
    assert refusal(sent.shards[0].read_bytes().replace(b'"vrts.shard/2"', NO_TEXT)) == "V720"
    key = (sent.plan / "key.json").read_bytes().replace(b'"vrts.plan/2"', NO_TEXT)
    (tmp_path / "key.json").write_bytes(key)
    with pytest.raises(Refused) as refused:
        read_key(tmp_path)
    assert codes(refused.value.diagnostics) == ["V723"]


def earn_more(sent: Sent) -> Callable[[dict[str, bytes]], None]:
    """Return a lie that agrees with itself: a result that is all points."""

    def tell(members: dict[str, bytes]) -> None:
        name = f"{pseudonym(sent, 'smith-ben')}/staff/result.json"
        told = {
            "mark": 10.0,
            "lowest": None,
            "parts": {**PARTS, "targets": 10.0},
            "losses": [],
            "checks": [check(10.0) | {"most": 10.0}],
        }
        members[name] = json.dumps(json.loads(members[name]) | told).encode()

    return tell


def test_of_two_files_that_differ_neither_is_taken(sent: Sent, tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()
    other = lied(sent, tmp_path / "b" / sent.results[0].name, earn_more(sent))
    for order in ((sent.results[0], other), (other, sent.results[0])):
        merged = sent.merge(tmp_path / "out", *order, sent.results[1])
        assert codes(merged.findings) == ["V725", "V726"]
        assert merged.findings[0].headline == (
            "shard 1: the result of `smith-ben` is not taken:"
            f" `{order[0]}` and `{order[1]}` differ in it"
        )
        assert merged.missing == ("smith-ben",)
        assert not Layout(tmp_path / "out").grader("smith-ben").exists()
    assert sent.merge(tmp_path / "out", *sent.results, sent.results[0]).findings == ()


def test_what_is_there_is_not_replaced_by_something_else(sent: Sent, tmp_path: Path) -> None:
    out = Layout(tmp_path / "out")
    sent.merge(out.root, *sent.results)
    before = files(out.root)
    (finding,) = sent.merge(out.root, lied(sent, tmp_path / "lie.zip", earn_more(sent))).findings
    place = out.grader("smith-ben")
    assert finding.headline == (
        "`lie.zip`, shard 1: the result of `smith-ben` is not taken:"
        f" `{place}` tells something else; delete the one that is wrong"
    )
    assert files(out.root) == before
    for half in (place, out.student("smith-ben")):
        (half / "result.json").write_bytes(b"{}")
        assert sent.merge(out.root).missing == ("smith-ben",)
        assert sent.merge(out.root, sent.results[0]).missing == ()
    assert files(out.root) == before


def test_a_file_that_cannot_be_read_costs_no_other(sent: Sent, tmp_path: Path) -> None:
    (tmp_path / "folder.zip").mkdir()
    sources = (tmp_path / "folder.zip", tmp_path / "gone.zip", sent.results[1])
    merged = sent.merge(tmp_path / "out", *sources)
    assert codes(merged.findings) == ["V722", "V722", "V726"]
    assert [d.headline.partition("`")[2][:8] for d in merged.findings[:2]] == [
        "folder.z",
        "gone.zip",
    ]
    assert len(merged.rows) == 3


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_a_pipe_keeps_nobody_waiting(sent: Sent, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.zip")
    merged = sent.merge(tmp_path / "out", tmp_path / "pipe.zip", sent.results[1])
    assert codes(merged.findings) == ["V722", "V726"]
    assert "`pipe.zip` holds no results of a shard: it is no file" in merged.findings[0].headline
    assert len(merged.rows) == 3


def test_only_whole_signed_and_sound_results_are_there_already(sent: Sent, tmp_path: Path) -> None:
    data = sent.shards[0].read_bytes()
    shard = read_shard(data)

    def there(path: Path) -> bool:
        return is_of(path, shard, digest_of(data))

    def without(members: dict[str, bytes]) -> None:
        for name in [n for n in members if n.startswith(pseudonym(sent, "smith-ben"))]:
            del members[name]

    assert there(sent.results[0])
    for change in (change_contents, drop_the_signature, forge_as_another_shard, unsign, spoil_text):
        assert not there(changed(sent.results[0], tmp_path / "bad.zip", change)), change
    assert not there(sent.results[1])
    assert not there(lied(sent, tmp_path / "bad.zip", without))
    assert not there(lied(sent, tmp_path / "bad.zip", change_mark))


def test_rows_that_are_missing_or_strange_are_named(sent: Sent, tmp_path: Path) -> None:
    def without(members: dict[str, bytes]) -> None:
        for name in [n for n in members if n.startswith(pseudonym(sent, "smith-ben"))]:
            members[name.replace(pseudonym(sent, "smith-ben"), "s" + "0" * 12)] = members.pop(name)

    merged = sent.merge(tmp_path / "out", lied(sent, tmp_path / "bad.zip", without))
    assert [d.headline for d in merged.findings[:2]] == [
        "`bad.zip`, shard 1: `s000000000000` is not of this shard",
        "`bad.zip`, shard 1: there is no result of `smith-ben` in it",
    ]
    assert [row.naming.identifier for row in merged.rows] == [CLASS[0].identifier]


def test_every_shard_has_a_secret_of_its_own_and_none_has_the_plans(sent: Sent) -> None:
    key = (sent.plan / "key.json").read_text()
    secrets = [json.loads(path.read_text())["secret"] for path in sent.shards]
    assert len({*secrets, json.loads(key)["secret"]}) == 3
    assert [secret in key for secret in secrets] == [False, False]
    for path in sent.results:
        with zipfile.ZipFile(path) as archive:
            held = b"".join(archive.read(name) for name in archive.namelist()).decode("latin-1")
        assert not any(secret in held for secret in secrets)


@pytest.mark.thorough
def test_a_plan_of_before_needs_a_word(sent: Sent, tmp_path: Path) -> None:
    """Its key, shards and results have no secret and no signature."""
    old = json.loads((sent.plan / "key.json").read_text()) | {"schema": "vrts.plan/1"}
    del old["secret"], old["staff"]["total"], old["student"]["total"]
    shard = json.loads(sent.shards[0].read_text()) | {"schema": "vrts.shard/1"}
    del shard["secret"]
    data = json.dumps(shard).encode()
    old["shards"][0]["sha256"] = digest_of(data)
    (tmp_path / "key.json").write_text(json.dumps(old))
    results = tmp_path / "old.zip"
    results.write_bytes(run_shard(read_shard(data), data, tmp_path / "work"))
    with zipfile.ZipFile(results) as archive:
        assert "signature.txt" not in archive.namelist()
    key, out = read_key(tmp_path), Layout(tmp_path / "out")
    with pytest.raises(Refused) as refused:
        merge(key, [results], out)
    assert codes(refused.value.diagnostics) == ["V731"]
    assert any("--unsigned" in words for words in refused.value.diagnostics[0].help)
    assert not (tmp_path / "out").exists()
    merged = merge(key, [results], out, unsigned=True)
    assert (len(merged.rows), codes(merged.findings)) == (2, ["V726"])

    def exact(members: dict[str, bytes]) -> None:
        """Points of a loss were not rounded to hundredths then: 23/6 and 5/3 for 5.5."""
        name = f"{pseudonym(sent, 'smith-ben')}/staff/result.json"
        result = json.loads(members[name])
        losses = [loss("23/6", 3.833333), loss("5/3", 1.666667)]
        versions = result["versions"] | {"scoring": 1}
        members[name] = json.dumps(result | {"losses": losses, "versions": versions}).encode()

    before = changed(results, tmp_path / "before.zip", exact)
    merged = merge(key, [before], Layout(tmp_path / "exact"), unsigned=True)
    assert (len(merged.rows), codes(merged.findings)) == (2, ["V726"])

    def tell(members: dict[str, bytes]) -> None:
        name = f"{pseudonym(sent, 'smith-ben')}/staff/result.json"
        members[name] = json.dumps(json.loads(members[name]) | {"mark": 10.0}).encode()

    bad = merge(key, [changed(results, tmp_path / "bad.zip", tell)], out, unsigned=True)
    assert "its mark is 10, and its parts give 4.5" in bad.findings[0].headline
    (tmp_path / "key.json").write_text(json.dumps(old | {"schema": "vrts.plan/2"}))
    with pytest.raises(Refused):
        read_key(tmp_path)


def test_damage_is_refused(sent: Sent, tmp_path: Path) -> None:
    whole = sent.results[0].read_bytes()
    with zipfile.ZipFile(sent.results[0]) as archive:
        page = next(i for i in archive.infolist() if i.filename.endswith("staff/report.html"))
    flipped = bytearray(whole)
    flipped[page.header_offset + 200] ^= 0xFF
    path = tmp_path / "bad.zip"
    for data in (b"", b"PK\x03\x04 and nothing", whole[: len(whole) // 2]):
        path.write_bytes(data)
        assert codes(sent.merge(tmp_path / "out", path).findings)[0] == "V722"
    path.write_bytes(bytes(flipped))
    (first, _) = sent.merge(tmp_path / "out", path).findings
    assert first.rule.code == "V725"
    assert first.headline.endswith("staff/report.html` is damaged")


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
    for changed_shard in (
        twice,
        evil,
        shard | {"schema": "vrts.shard/9"},
        shard | {"schema": "vrts.shard/1"},
        shard | {"more": 1},
    ):
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
        unlike = [n for n in one.namelist() if one.read(n) != other.read(n)]
        assert unlike == ["marked.json", "signature.txt"], "they tell how long it took"
        assert json.loads(one.read("marked.json"))["shard"] == digest_of(data)
