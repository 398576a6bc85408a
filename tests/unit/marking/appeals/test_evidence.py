"""Evidence: all that a mark rests on, nothing of others; the same result, or what differs."""

import io
import json
import shutil
import zipfile
from collections.abc import Callable
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import msgspec
import pytest
from click.testing import CliRunner, Result

from tests.unit.check.proof.test_certificate import formatted
from tests.unit.marking.appeals.support import BAD, EXAMPLE, GOOD, SECRET, marked_class, submissions
from vrts.assignments.pack import staff_zip
from vrts.assignments.task_folder import read_folder
from vrts.check.proof.certificate import certificate_bytes, read_certificate
from vrts.cli.main import vrts
from vrts.marking.appeals.evidence import CONTENTS, Contents
from vrts.marking.appeals.evidence_zip import known_name, read_evidence
from vrts.marking.appeals.pack_evidence import pack_evidence
from vrts.marking.appeals.written import read_written
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment, Excuse, Extend, Give, Item, Undo
from vrts.marking.by_hand.override_text import add_overrides
from vrts.marking.by_hand.overrides import Override
from vrts.marking.layout import Layout
from vrts.marking.result import Kind, from_bytes, to_bytes
from vrts.marking.row import Row
from vrts.marking.submission.one import Wanted

Spoil = Callable[[dict[str, bytes]], bytes]
HIDDEN = '[[via]]\nname = "gate 4711"\nat_mm = [600, 200, 500]\nradius_mm = 40\n'


class Marked(NamedTuple):
    """A class that was marked, and where everything is."""

    home: Path
    out: Path
    download: Path
    task: Path


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Marked:
    """Mark anna and somebody else by a task with hidden checks."""
    home = tmp_path_factory.mktemp("home")
    task = home / "lab1"
    shutil.copytree(EXAMPLE, task, ignore=shutil.ignore_patterns("submissions", "pictures"))
    (task / "staff").mkdir()
    (task / "staff" / "task.toml").write_text(HIDDEN)
    (task / "staff" / "last-year.txt").write_text(SECRET)
    download = submissions(home)
    (download / "cara").mkdir()
    marked_class(home / "out", download, task / "task.toml", Wanted(pages=True, recordings=True))
    return Marked(home, home / "out", download, task)


@pytest.fixture(scope="module")
def evidence(marked: Marked) -> bytes:
    """Return anna's evidence."""
    return pack_evidence(read_written(marked.out), "anna")[1]


def members(data: bytes) -> dict[str, bytes]:
    """Return the files in a zip."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def zipped(files: dict[str, bytes]) -> bytes:
    """Return a zip of files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return buffer.getvalue()


def sealed(files: dict[str, bytes]) -> bytes:
    """Return a zip of files, with digests that fit."""
    contents = msgspec.json.decode(files[CONTENTS], type=Contents)
    digests = {name: sha256(data).hexdigest() for name, data in files.items() if name != CONTENTS}
    whole = msgspec.structs.replace(contents, sha256=digests)
    return zipped({**files, CONTENTS: msgspec.json.encode(whole)})


def call(*words: object) -> Result:
    """Call `vrts grade`."""
    return CliRunner().invoke(vrts, ["grade", *map(str, words)])


def reproduce(folder: Path, data: bytes) -> Result:
    """Call `vrts grade reproduce` with a zip."""
    path = folder / "evidence.zip"
    path.write_bytes(data)
    return call("reproduce", path)


@pytest.mark.thorough
def test_everything_is_in_it(marked: Marked, evidence: bytes) -> None:
    found = members(evidence)
    assert set(found) == {
        *("README.txt", "evidence.json", "row.json", "intake.csv", "task.zip", "proof.cert"),
        *(f"staff/{name}" for name in ("result.json", "report.html")),
        *(f"student/{name}" for name in ("result.json", "report.html", "run.rrd")),
        "submission/anna.v2",
    }
    assert found["submission/anna.v2"] == GOOD
    sent = Layout(marked.out).student("anna") / "run.rrd"
    assert found["student/run.rrd"] == sent.read_bytes()
    header, line = found["intake.csv"].decode("utf-8-sig").splitlines()
    assert header.startswith("id,")
    assert line.startswith("anna,")
    contents = msgspec.json.decode(found["evidence.json"], type=Contents)
    assert contents.command[:2] == ("vrts", "grade")
    assert {"vrts", "scoring", "python", "coal", "numpy", "platform"} <= contents.versions.keys()
    assert contents.sha256 == {
        name: sha256(data).hexdigest() for name, data in found.items() if name != CONTENTS
    }
    assert {"lab1/staff/task.toml", "lab1/task.toml"} <= members(found["task.zip"]).keys()


@pytest.mark.thorough
def test_nothing_of_anybody_else_is_in_it(marked: Marked, evidence: bytes) -> None:
    names = (SECRET, SECRET.split()[0], "Zwölfer", "Zw\\u00f6lfer", "cara")
    inside = members(evidence)
    for name, data in (*inside.items(), *members(inside["task.zip"]).items()):
        if name.endswith(".rrd"):
            continue
        text = f"{name} {data.decode('utf-8', 'replace')}"
        assert not [word for word in names if word in text], name
        assert sha256(BAD).hexdigest() not in text
    assert str(marked.download) not in inside["evidence.json"].decode()


@pytest.mark.thorough
def test_the_contacts_of_a_mark_are_proven_by_a_certificate(
    evidence: bytes, tmp_path: Path
) -> None:
    files = members(evidence)
    assert "its certificate holds: nothing touches anything" in reproduce(tmp_path, evidence).output
    assert str(tmp_path) not in files["proof.cert"].decode("latin-1")
    read = read_certificate(files["proof.cert"])
    other = read.claims._replace(clearance_m=1.0)
    said = {name: read.said[name] for name in read.said.keys() - {"format", "sha256", "claims"}}
    files["proof.cert"] = certificate_bytes(said, other, read.evidence)
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 1
    assert "V547 certificate-does-not-prove" in found.output
    files["proof.cert"] = formatted(members(evidence)["proof.cert"], 2)
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 0, found.output  # the mark is made again without it
    assert found.stdout.startswith("anna: the same result, ")
    assert "its certificate holds" not in found.stdout
    assert "warning[V550 certificate-format]" in found.stderr
    assert "was written by an older vrts" in found.stderr
    assert "help: pack the evidence again with `vrts grade evidence`" in found.output


@pytest.mark.thorough
def test_the_same_result_comes_again(marked: Marked, evidence: bytes, tmp_path: Path) -> None:
    found = reproduce(tmp_path, evidence)
    assert found.exit_code == 0, found.output
    mark = from_bytes(members(evidence)["staff/result.json"]).mark
    first, proven = found.stdout.splitlines()
    assert first == f"anna: the same result, {mark} of 10"
    assert proven == "  its certificate holds: nothing touches anything"
    assert not found.stderr
    assert pack_evidence(read_written(marked.out), "anna")[1] == evidence


def test_the_first_difference_is_named(evidence: bytes, tmp_path: Path) -> None:
    files = members(evidence)
    row = msgspec.json.decode(files["row.json"], type=Row)
    better = msgspec.structs.replace(row.result, lowest=9.9, cause="well done")
    files["staff/result.json"] = to_bytes(better)
    files["row.json"] = msgspec.json.encode(msgspec.structs.replace(row, result=better))
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 1
    mark = f"{row.result.mark:.1f} of 10"
    assert found.stdout.startswith(f"anna: another result, with the same mark: {mark}\n")
    assert "\n  first difference, in the result for" in found.stdout
    assert ": lowest was 9.9, is now null" in found.stdout


def test_the_result_for_the_student_must_be_the_same_too(evidence: bytes, tmp_path: Path) -> None:
    files = members(evidence)
    sent = from_bytes(files["student/result.json"])
    files["student/result.json"] = to_bytes(msgspec.structs.replace(sent, cause="well done"))
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 1
    assert 'in the result for the student: cause was "well done", is now ' in found.stdout


def test_a_result_of_another_version_is_compared_in_all_but_versions(
    evidence: bytes, tmp_path: Path
) -> None:
    files = members(evidence)
    row = msgspec.json.decode(files["row.json"], type=Row)
    for who in ("staff", "student"):
        result = from_bytes(files[f"{who}/result.json"])
        versions = msgspec.structs.replace(result.versions, vrts="0.0.9")
        old = msgspec.structs.replace(result, versions=versions, key=64 * "0")
        files[f"{who}/result.json"] = to_bytes(old)
        if who == "staff":
            files["row.json"] = msgspec.json.encode(msgspec.structs.replace(row, result=old))
    contents = msgspec.json.decode(files[CONTENTS], type=Contents)
    older = {**contents.versions, "vrts": "0.0.9"}
    files[CONTENTS] = msgspec.json.encode(msgspec.structs.replace(contents, versions=older))
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 0, found.output
    assert "note: vrts: 0.0.9 when it was packed, " in found.stderr

    student = from_bytes(files["student/result.json"])
    said = to_bytes(msgspec.structs.replace(student, cause="in words of before"))
    found = reproduce(tmp_path, sealed({**files, "student/result.json": said}))
    assert found.exit_code == 3, found.output
    row = msgspec.json.decode(files["row.json"], type=Row)
    mark = f"{row.result.mark:.1f} of 10"
    assert f"anna: the same mark, {mark}; what is said about" in found.stdout
    result = msgspec.structs.replace(row.result, mark=0.3)
    files["staff/result.json"] = to_bytes(result)
    files["row.json"] = msgspec.json.encode(msgspec.structs.replace(row, result=result))
    found = reproduce(tmp_path, sealed(files))
    assert found.exit_code == 1
    assert f"anna: another result: 0.3 of 10 in the evidence, {mark} now\n" in found.stdout


def without(name: str) -> Spoil:
    return lambda files: zipped({key: data for key, data in files.items() if key != name})


def other_program(files: dict[str, bytes]) -> bytes:
    return sealed({**files, "submission/anna.v2": BAD})


def other_row(files: dict[str, bytes]) -> bytes:
    row = msgspec.json.decode(files["row.json"], type=Row)
    moved = msgspec.structs.replace(row.result, mark=1.0)
    return sealed(
        {**files, "row.json": msgspec.json.encode(msgspec.structs.replace(row, result=moved))}
    )


def other_task(files: dict[str, bytes]) -> bytes:
    contents = msgspec.json.decode(files[CONTENTS], type=Contents)
    away = msgspec.structs.replace(contents.place, lab="over/lab/../../../../etc/passwd")
    changed = msgspec.structs.replace(contents, place=away)
    return sealed({**files, CONTENTS: msgspec.json.encode(changed)})


def lying_about_size(files: dict[str, bytes]) -> bytes:
    data = zipped(files)
    size = len(files["task.zip"]).to_bytes(4, "little")
    assert data.count(size) >= 2
    return data.replace(size, (5).to_bytes(4, "little"))


SPOILED: list[tuple[Spoil, str, str]] = [
    (lambda _: b"", "V764", "incomplete, or is no zip file"),
    (lambda _: b"no zip", "V764", "incomplete, or is no zip file"),
    (lambda f: zipped(f)[:-500], "V764", "incomplete, or is no zip file"),
    (lambda f: zipped(f)[:900] + bytes(60) + zipped(f)[960:], "V764", "it is"),
    (lying_about_size, "V764", "it is incomplete, or is no zip file"),
    (lambda f: zipped({**f, "../evil": b""}), "V764", "`../evil` does not belong into it"),
    (lambda f: zipped({**f, "/etc/cron.d/x": b""}), "V764", "does not belong into it"),
    (lambda f: zipped({**f, "submission/..": b""}), "V764", "does not belong into it"),
    (without(CONTENTS), "V764", "there is no `evidence.json` in it"),
    (lambda f: zipped({**f, CONTENTS: b"{}"}), "V764", "`evidence.json` is not as vrts"),
    (lambda f: zipped({**f, CONTENTS: b" " * 1_000_001}), "V764", "more than 1,000,000 bytes"),
    (
        lambda f: zipped({**f, **{f"submission/x{k}": b"" for k in range(200)}}),
        "V764",
        "more than 200 files",
    ),
    (lambda f: sealed({**f, "row.json": b"{}"}), "V764", "`row.json` is not as vrts writes it"),
    (without("row.json"), "V765", "`row.json` is missing"),
    (lambda f: zipped({**f, "intake.csv": b"x"}), "V765", "`intake.csv` has other bytes"),
    (lambda f: zipped({**f, "submission/b.v2": b""}), "V765", "`submission/b.v2` was added"),
    (other_program, "V765", "the program is not the one that the result is about"),
    (other_row, "V765", "its parts are about different results"),
    (other_task, "V765", "that it names is not in it"),
]


@pytest.mark.parametrize(("spoil", "code", "words"), SPOILED)
def test_what_is_damaged_or_altered_has_one_diagnostic(
    evidence: bytes,
    tmp_path: Path,
    spoil: Spoil,
    code: str,
    words: str,
) -> None:
    found = reproduce(tmp_path, spoil(members(evidence)))
    assert found.exit_code == 1, found.output
    assert found.stderr.count("error[") == 1
    assert f"error[{code} " in found.stderr
    assert words in found.stderr
    assert not found.stdout


def test_names_lead_nowhere() -> None:
    assert known_name("over/lab/lab.toml")
    assert known_name("submission/päck.v2")
    for name in (
        *("over/lab/..", "over/other/x", "over/lab/a/b", "submission/a b", "submission/con.v2"),
        *("submission/", "submission", "task.zip/x", "staff/x", "over/lab/.hidden", "C:/x"),
    ):
        assert not known_name(name), name


@pytest.mark.thorough
def test_a_change_by_hand_goes_along(marked: Marked, tmp_path: Path) -> None:
    shutil.copytree(marked.out, tmp_path / "out")
    changes = [
        Override(name, 1 - k, None, f"reason {name}", "RH", "2026-11-30")  # type: ignore[arg-type]
        for k, name in enumerate(("anna", "cara"))
    ]
    add_overrides(Layout(tmp_path / "out").overrides, changes, ("anna", "cara"))
    row, data = pack_evidence(read_written(tmp_path / "out"), "anna")
    text = members(data)["overrides.toml"].decode()
    assert "reason anna" in text
    assert "cara" not in text
    assert row.change is not None
    assert row.change.delta == "1"
    assert "reason anna" in members(data)["README.txt"].decode()


@pytest.mark.thorough
def test_decisions_of_graders_go_along_and_nobody_else_is_in_them(
    marked: Marked, tmp_path: Path
) -> None:
    shutil.copytree(marked.out, tmp_path / "out")
    both = ("anna", "cara")
    said = (
        Item(0, "", "style", "no comments", "-1/2"),
        Give(0, "", "style", both, programs=dict.fromkeys(both, "none")),
        Comment(0, "", "cara", "about cara"),
        Comment(0, "", "anna", "about anna"),
        Comment(0, "", "anna", "PRIVATE", private=True),
        Undo(0, "", ("rh:3", "rh:4")),
        Extend(0, "", both, "2026-12-01T00:00:00+01:00", "ill"),
        Excuse(0, "", both, "ill"),
    )
    add_decisions(Layout(tmp_path / "out").decisions, "RH", said, datetime.now(UTC))
    row, data = pack_evidence(read_written(tmp_path / "out"), "anna")
    assert row.result.kind is Kind.EXCUSED
    lines = [json.loads(line) for line in members(data)["decisions.jsonl"].splitlines()]
    assert [line["record"] for line in lines] == [f"rh:{k}" for k in (1, 2, 4, 6, 7, 8)]
    assert lines[3]["records"] == ["rh:4"]
    everything = b"".join(members(data).values())
    assert b"cara" not in everything
    assert b"PRIVATE" not in everything
    place = tmp_path / "evidence.zip"
    place.write_bytes(data)
    assert read_evidence(place).row == row


@pytest.mark.thorough
def test_a_program_that_is_not_there_any_more_is_told(marked: Marked, tmp_path: Path) -> None:
    moved = tmp_path / "moved"
    shutil.copytree(marked.download, moved)
    good = tmp_path / "good.zip"
    words = ("evidence", "anna", "--from", marked.out, "-o", good, "--submissions", moved)
    assert call(*words).exit_code == 0
    assert members(good.read_bytes())["submission/anna.v2"] == GOOD
    (moved / "anna" / "anna.v2").write_bytes(GOOD + b"\n")
    found = call(*words)
    assert found.exit_code == 1
    assert "error[V762 program-changed-since]" in found.stderr
    (moved / "anna" / "anna.v2").unlink()
    assert "the file is not there" in call(*words).stderr
    gone = call(*words[:-1], tmp_path / "nowhere")
    assert gone.exit_code == 2
    assert "say with `--submissions` where the download is now" in gone.stderr


@pytest.mark.thorough
def test_a_copy_of_the_task_is_the_task(marked: Marked, tmp_path: Path) -> None:
    shutil.copytree(marked.task, tmp_path / "lab1")
    words = ("-o", tmp_path / "e.zip", "--task", tmp_path / "lab1")
    assert call("evidence", "anna", "--from", marked.out, *words).exit_code == 0


@pytest.mark.parametrize("file", ["task.toml", "staff/task.toml"])
def test_a_task_that_has_changed_is_told(marked: Marked, tmp_path: Path, file: str) -> None:
    other = tmp_path / "lab1"
    shutil.copytree(marked.task, other)
    words = ("evidence", "anna", "--from", marked.out, "-o", tmp_path / "e.zip", "--task", other)
    changed = (other / file).read_text().replace("600, 200", "610, 200")
    (other / file).write_text(changed.replace("position_mm = 10", "position_mm = 11"))
    found = call(*words)
    assert found.exit_code == 1
    assert "error[V763 task-changed-since]: the task is not the one by which" in found.stderr
    assert not (tmp_path / "e.zip").exists()


def test_where_nothing_was_handed_in_there_is_nothing_to_mark(
    marked: Marked, tmp_path: Path
) -> None:
    _, data = pack_evidence(read_written(marked.out), "cara")
    assert not [name for name in members(data) if name.startswith("submission/")]
    found = reproduce(tmp_path, data)
    assert found.exit_code == 3
    assert found.stdout.startswith("cara: nothing to mark again: ")


def test_who_is_not_in_the_class_is_told(marked: Marked) -> None:
    found = call("evidence", "anan", "--from", marked.out)
    assert found.exit_code == 1
    assert "error[V761 nobody-of-that-name]: there is no student `anan`" in found.stderr
    assert "did you mean `anna`?" in found.stderr
    part = call("evidence", "NN", "--from", marked.out)
    assert "did you mean `anna`?" in part.stderr
    assert "V760" in call("evidence", "anna", "--from", marked.download).stderr


def test_a_result_newer_than_the_list_is_told(marked: Marked, tmp_path: Path) -> None:
    shutil.copytree(marked.out, tmp_path / "out")
    place = Layout(tmp_path / "out").grader("anna") / "result.json"
    newer = msgspec.structs.replace(from_bytes(place.read_bytes()), mark=1.0)
    place.write_bytes(to_bytes(newer))
    found = call("evidence", "anna", "--from", tmp_path / "out")
    assert "V760" in found.stderr
    assert "is newer than the list of marks" in found.stderr


def test_change_command_adds_to_the_file(marked: Marked, tmp_path: Path) -> None:
    shutil.copytree(marked.out, tmp_path / "out")
    words = ("change", "anna", "--from", tmp_path / "out", "--reason", "late bus", "--who", "RH")
    found = call(*words, "--mark", "7,5", "--date", "2026-11-30")
    assert found.exit_code == 0, found.output
    assert "7.5 from now on" in found.stdout
    assert "vrts grade decisions" in found.stderr, (
        "exports count it; this brings the rest up to date"
    )
    assert 'date = "2026-11-30"' in Layout(tmp_path / "out").overrides.read_text()
    assert call(*words).exit_code == 2
    assert call(*words, "--mark", "7", "--delta", "1").exit_code == 2
    assert call(*words, "--delta", "eleven").exit_code == 2
    assert call(*words, "--delta", "1", "--date", "today").exit_code == 1


@pytest.mark.thorough
@pytest.mark.parametrize(
    "packed",
    [
        pytest.param(False, id="folder and lab"),
        pytest.param(True, id="packed", marks=pytest.mark.thorough),
    ],
)
def test_a_packed_task_and_a_lab_go_along(marked: Marked, tmp_path: Path, packed: bool) -> None:
    (tmp_path / "anna.v2").write_bytes(BAD)
    task, more = marked.task, ["--lab", str(tmp_path / "lab.toml")]
    (tmp_path / "lab.toml").write_text('[lab]\ntitle = "Room 112"\n[lab.table]\ntop_z_mm = -310\n')
    if packed:
        task, more = tmp_path / "lab1-staff.zip", []
        files = read_folder(marked.task)
        task.write_bytes(staff_zip(files._replace(staff={}), 0))
    words = (task, tmp_path / "anna.v2", "-o", tmp_path / "out", "--no-pages", *more)
    assert call(*words).exit_code == 0
    zipped = tmp_path / "anna.zip"
    found = call("evidence", "anna", "--from", tmp_path / "out", "-o", zipped)
    assert found.exit_code == 0, found.output
    inside = members(zipped.read_bytes())
    if packed:
        assert inside["task.zip"] == task.read_bytes()
    else:
        assert inside["over/lab/lab.toml"] == (tmp_path / "lab.toml").read_bytes()
    again = reproduce(tmp_path, zipped.read_bytes())
    assert again.exit_code == 0, again.output
