"""Laws of the intake: whatever is handed in, every row has a safe id, and nothing is raised."""

import io
import tempfile
import zipfile
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.unit.marking.intake.support import DOCX, PDF, PICK, PROSE, STEPS, zipped
from vrts.base.safe_names import safe
from vrts.marking.intake.candidate import data_of
from vrts.marking.intake.row import Intake
from vrts.marking.intake.tables.edited_table import read_rows
from vrts.marking.intake.tables.intake_table import write_rows
from vrts.marking.intake.take_in import take_in
from vrts.marking.intake.tree.file_names import same_name
from vrts.marking.intake.tree.opening import open_place
from vrts.pipeline.files import CannotRead

PIECES = st.one_of(
    st.sampled_from(
        [
            "Anna Berger_101_assignsubmission_file_",
            "Ben_102_assignsubmission_onlinetext",
            "bergeranna_LATE_31_901_pick-1.v2",
            "submission_metadata.yml",
            "submission_7",
            "2026-03-01-10-00-00",
            "pick.v2",
            "pick (1).v2",
            "pick.v2.txt",
            "work.zip",
            "__MACOSX",
            "CON",
            "..",
            ".",
            "",
            "!",
            "C:",
            "=1+1",
            "'",
        ]
    ),
    st.text(st.characters(codec="utf-8"), max_size=4),
)
NAMES = st.lists(PIECES, min_size=1, max_size=3).map("/".join)
CONTENTS = st.one_of(
    st.sampled_from([PICK, STEPS, PROSE, PDF, DOCX, b"", zipped({"pick.v2": PICK})]),
    st.binary(max_size=40),
)
DOWNLOADS = st.dictionaries(NAMES, CONTENTS, max_size=6)


def written(folder: str, data: bytes) -> Path:
    place = Path(folder) / "download"
    place.write_bytes(data)
    return place


def archive(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as target:
        infos = {(info := zipfile.ZipInfo(name)).filename: (info, files[name]) for name in files}
        for info, data in infos.values():
            target.writestr(info, data)
    return buffer.getvalue()


def lawful(found: Intake, place: Path) -> None:
    ids = [row.identifier for row in found.rows]
    assert len({same_name(identifier) for identifier in ids}) == len(ids)
    with open_place(place) as tree:
        for row in found.rows:
            assert safe(row.identifier) == row.identifier
            assert len(row.identifier.encode()) <= 110
            assert row.file is not None or row.problem is not None
            if row.problem is None:
                assert data_of(tree, row.file or "")
                assert row.attempts[-1].file == row.file
        assert read_rows(write_rows(found.rows), "intake.csv", tree, found) == (found.rows, ())


@given(DOWNLOADS)
@settings(max_examples=examples(100), deadline=None)
def test_any_download_becomes_rows(files: dict[str, bytes]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        try:
            data = archive(files)
            place = written(folder, data)
            found = take_in(place, program="pick")
        except (CannotRead, UnicodeEncodeError):
            return  # damaged metadata, or no name that a zip can hold
        lawful(found, place)


@given(DOWNLOADS, st.integers(0), st.binary(min_size=1, max_size=4))
@settings(max_examples=examples(100), deadline=None)
def test_any_damage_is_told_or_harmless(files: dict[str, bytes], at: int, change: bytes) -> None:
    data = bytearray(zipped({"anna/work.zip": archive({**files, "pick.v2": PICK})}))
    inner = bytearray(archive({**files, "pick.v2": PICK}))
    inner[at % len(inner) : at % len(inner) + len(change)] = change
    data[at % len(data) : at % len(data) + len(change)] = change
    with tempfile.TemporaryDirectory() as folder:
        for damaged in (bytes(data), zipped({"anna/work.zip": bytes(inner), "ben/x.v2": PICK})):
            place = written(folder, damaged)
            try:
                found = take_in(place, program="pick")
            except CannotRead:
                continue
            for row in found.rows:
                assert row.file is not None or row.problem is not None


@given(st.one_of(st.binary(max_size=200), st.text(max_size=200).map(str.encode)))
@settings(max_examples=examples(100), deadline=None)
def test_any_table_is_read_or_refused(data: bytes) -> None:
    with tempfile.TemporaryDirectory() as folder:
        place = written(folder, zipped({"anna/pick.v2": PICK}))
        fresh = take_in(place, program="pick")
        with open_place(place) as tree:
            for table in (data, b"id,file,problem\n" + data, b"id;file;problem;due\n" + data):
                rows, diagnostics = read_rows(table, "intake.csv", tree, fresh)
                assert rows is not None or any(d.is_error for d in diagnostics)


@given(st.one_of(st.binary(max_size=100), st.text(max_size=100).map(str.encode)))
@settings(max_examples=examples(100), deadline=None)
def test_any_metadata_are_read_or_refused(data: bytes) -> None:
    with tempfile.TemporaryDirectory() as folder:
        files = {"submission_metadata.yml": data, "submission_7/pick.v2": PICK}
        place = written(folder, zipped(files))
        try:
            lawful(take_in(place, program="pick"), place)
        except CannotRead as refused:
            assert refused.message.startswith("`submission_metadata.yml`")  # noqa: PT017
