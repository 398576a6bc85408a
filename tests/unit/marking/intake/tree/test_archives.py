"""Archives and folders that nobody should trust: each costs its own row, and no other."""

import io
import os
import zipfile
from pathlib import Path

import pytest

from tests.unit.marking.intake.support import PICK, put, zipped
from vrts.marking.intake.candidate import (
    LARGEST_ARCHIVE,
    MOST_MEMBERS,
    MOST_READ,
    data_of,
)
from vrts.marking.intake.row import Kind, Row
from vrts.marking.intake.take_in import take_in
from vrts.marking.intake.tree.opening import Unreadable, open_place
from vrts.pipeline.files import CannotRead

GOOD = "Ben Wolf_2_assignsubmission_file_/pick.v2"
BAD = "Anna Berger_1_assignsubmission_file_/work.zip"


def rows(tmp_path: Path, archive: bytes) -> tuple[Row, Row]:
    """Return the row of a student with an archive, and that of one with a program."""
    place = put(tmp_path / "download", {BAD: archive, GOOD: PICK})
    anna, ben = take_in(place, program="pick").rows
    return anna, ben


def linked(name: str, kind: int) -> bytes:
    info = zipfile.ZipInfo(name)
    info.external_attr = kind << 16
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr(info, "/etc/passwd")
        archive.writestr("pick.v2", PICK)
    return buffer.getvalue()


def encrypted() -> bytes:
    data = bytearray(zipped({"pick.v2": PICK}))
    data[6] |= 1  # the flags of the member, and in the table of contents
    data[data.index(b"PK\x01\x02") + 8] |= 1
    return bytes(data)


HOSTILE = {
    "a path that leads out": (zipped({"../../pick.v2": PICK}), "leads out of the archive"),
    "an absolute path": (zipped({"/etc/pick.v2": PICK}), "leads to a place of its own"),
    "a drive": (zipped({"C:\\pick.v2": PICK}), "leads to a place of its own"),
    "a path of Windows that leads out": (zipped({"a\\..\\..\\x.v2": PICK}), "leads out"),
    "a name with a line end": (zipped({"a\nb.v2": PICK}), "has control characters in its name"),
    "a link": (linked("secret.v2", 0o120777), "`secret.v2` in it is a link or a device"),
    "a device": (linked("null.v2", 0o020666), "is a link or a device"),
    "names that differ in case": (zipped({"pick.v2": PICK, "Pick.v2": PICK}), "one name on some"),
    "names that differ in their form": (
        zipped({"\u00e9.v2": PICK, "e\u0301.v2": PICK}),
        "is there twice",
    ),
    "a file and a folder of one name": (zipped({"a": PICK, "A/b.v2": PICK}), "one name on some"),
    "a bomb": (zipped({"pick.v2": bytes(10_000_000)}), "it unpacks to 10 MB"),
    "a bomb of many": (
        zipped({f"{n}.v2": b"; " + bytes(100_000) for n in range(100)}),
        "it unpacks to 10 MB",
    ),
    "too many files": (zipped({f"{n}": b"" for n in range(MOST_MEMBERS + 1)}), "more than 1,000"),
    "an encrypted file": (encrypted(), "is encrypted"),
}


@pytest.mark.parametrize("title", HOSTILE)
def test_a_hostile_archive_is_refused(title: str, tmp_path: Path) -> None:
    archive, words = HOSTILE[title]
    anna, ben = rows(tmp_path, archive)
    assert anna.problem is not None
    assert anna.problem.kind is Kind.ARCHIVE
    assert words in anna.problem.sentence
    assert ben.problem is None


def test_bytes_of_a_refused_archive_cannot_be_had(tmp_path: Path) -> None:
    archive, _ = HOSTILE["a path that leads out"]
    rows(tmp_path, archive)
    with open_place(tmp_path / "download") as tree:
        assert data_of(tree, GOOD) == PICK
        for name in (
            f"{BAD}!../../pick.v2",
            f"{BAD}!pick.v2",
            "../download/" + GOOD,
            "/etc/passwd",
        ):
            with pytest.raises(Unreadable):
                data_of(tree, name)


def test_a_file_that_is_longer_than_it_says_is_refused(tmp_path: Path) -> None:
    data = zipped({"pick.v2": PICK * 5_000})
    lying = data.replace(len(PICK * 5_000).to_bytes(4, "little"), (40).to_bytes(4, "little"))
    anna, _ = rows(tmp_path, lying)
    assert anna.problem is not None
    assert anna.problem.kind is Kind.ARCHIVE


@pytest.mark.thorough
def test_no_more_is_unpacked_than_allowed(tmp_path: Path) -> None:
    random = os.urandom(1_000_000)
    archive = zipped({f"{n}.bin": random for n in range(MOST_READ // 1_000_000 + 1)})
    anna, _ = rows(tmp_path, archive)
    assert anna.problem is not None
    assert anna.problem.kind is Kind.ARCHIVE
    assert "unpacks to more than 32 MB" in anna.problem.sentence


def test_an_archive_that_is_too_large_is_not_opened(tmp_path: Path) -> None:
    place = put(tmp_path / "download", {BAD: zipped({"pick.v2": PICK}), GOOD: PICK})
    with (place / BAD).open("r+b") as file:
        file.truncate(LARGEST_ARCHIVE + 1)  # sparse
    anna, ben = take_in(place, program="pick").rows
    assert anna.problem is not None
    assert anna.problem.kind is Kind.TOO_LARGE
    assert ben.problem is None


def test_links_and_pipes_of_a_folder_are_not_followed(tmp_path: Path) -> None:
    secret = tmp_path / "secret.v2"
    secret.write_bytes(PICK)
    place = put(tmp_path / "download", {"anna/": b"", "ben/": b"", "eva/pick.v2": PICK})
    (place / "anna" / "pick.v2").symlink_to(secret)
    (place / "ben" / "lab").symlink_to(tmp_path, target_is_directory=True)
    os.mkfifo(place / "eva" / "waits.v2")
    found = take_in(place, program="pick")
    anna, ben, eva = found.rows
    for row in (anna, ben):
        assert row.file is None
        assert row.problem is not None
        assert row.problem.kind is Kind.UNREADABLE
        assert "is a link" in row.problem.sentence
    assert eva.problem is None
    assert any("waits.v2` is a device or a pipe" in remark for remark in found.remarks)


def test_a_file_that_becomes_a_link_after_the_intake_is_not_followed(tmp_path: Path) -> None:
    place = put(tmp_path / "download", {"anna/pick.v2": PICK})
    with open_place(place) as tree:
        (place / "anna" / "pick.v2").unlink()
        (place / "anna" / "pick.v2").symlink_to("/etc/passwd")
        with pytest.raises(Unreadable):
            data_of(tree, "anna/pick.v2")


def test_names_that_are_no_utf8_are_read(tmp_path: Path) -> None:
    place = put(tmp_path / "download", {"anna/pick.v2": PICK})
    raw = os.fsencode(place) + b"/M\xfcller"
    os.mkdir(raw)
    with open(raw + b"/pick.v2", "wb") as file:
        file.write(PICK)
    assert [row.file for row in take_in(place, program="pick").rows] == [
        "Müller/pick.v2",
        "anna/pick.v2",
    ]


def test_names_in_zips_are_read_as_they_were_meant(tmp_path: Path) -> None:
    data = zipped({"M\u00fcller/pick.v2": PICK, "anna/pick.v2": PICK})
    unmarked = bytearray(data)  # UTF-8 without saying so, as the archiver of a Mac writes it
    for sign, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        unmarked[unmarked.index(sign) + offset + 1] &= ~0x08
    place = tmp_path / "download.zip"
    place.write_bytes(bytes(unmarked))
    assert [row.identifier for row in take_in(place, program="pick").rows] == ["Müller", "anna"]


@pytest.mark.parametrize("data", [b"PK\x03\x04 and then nothing", zipped({"a": PICK})[:-4]])
def test_a_damaged_download_is_told(data: bytes, tmp_path: Path) -> None:
    place = tmp_path / "download.zip"
    place.write_bytes(data)
    with pytest.raises(CannotRead, match="is damaged or not complete"):
        take_in(place, program="pick")


def test_a_place_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(CannotRead, match="there is no"):
        take_in(tmp_path / "nowhere", program="pick")


@pytest.mark.parametrize(
    "metadata",
    [
        b"[",
        b"- a\n- b\n",
        b"a: &a [*a]\n&b c: *b\nd: *x\n",
        b"[" * 5_000,
        b"submission_2: !!python/object x",
    ],
)
def test_damaged_metadata_of_gradescope_are_told(metadata: bytes, tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"submission_metadata.yml": metadata, "submission_1/a.v2": PICK})
    if metadata.endswith(b"x"):  # a tag makes no object: the folder stands for itself
        assert [row.identifier for row in take_in(place, program="pick").rows][1] == "submission_1"
        return
    with pytest.raises(CannotRead, match=r"submission_metadata\.yml"):
        take_in(place, program="pick")


def test_aliases_of_metadata_are_not_expanded(tmp_path: Path) -> None:
    lines = ["submission_a0: &a0 {x: lol}"]
    lines += [f"submission_a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 40)]
    lines += ["submission_1:", "  :submitters: *a39", "  :created_at: 2026-03-01 10:00:00 Z"]
    files = {"submission_metadata.yml": "\n".join(lines).encode(), "submission_1/a.v2": PICK}
    found = take_in(put(tmp_path / "d", files), program="pick")
    assert any(row.file == "submission_1/a.v2" for row in found.rows)
