"""Zip files that lie: about sizes, names, and how much there is of them."""

import io
import zipfile

import pytest

from vrts.base.zips import BadZip, Flaw, Unpacker


def zipped(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def test_members_are_told_before_anything_is_unpacked() -> None:
    found = Unpacker(zipped({"a/": b"", "a/b": b"x" * 1000})).members
    assert [(name, member.size) for name, member in found.items()] == [("a/", 0), ("a/b", 1000)]
    assert found["a/b"].packed < 100
    assert all(member.plain for member in found.values())


@pytest.mark.parametrize("kind", [0o120777, 0o060666, 0o010666], ids=["link", "device", "pipe"])
def test_links_and_devices_are_told(kind: int) -> None:
    info = zipfile.ZipInfo("a")
    info.external_attr = kind << 16
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr(info, "/etc/passwd")
    assert not Unpacker(buffer.getvalue()).members["a"].plain


def test_a_file_is_read_without_keeping_it_in_memory() -> None:
    file = io.BytesIO(zipped({"a": b"hello", "b": b"world"}))
    unpacker = Unpacker(file)
    assert unpacker.read("b") == b"world"
    assert unpacker.start("a", 2) == b"he"
    assert not file.closed


def test_a_table_of_contents_is_bounded() -> None:
    data = zipped({f"{n:0100}": b"" for n in range(100)})
    assert len(Unpacker(data).members) == 100
    with pytest.raises(BadZip) as refused:
        Unpacker(data, contents=5_000)
    assert refused.value.flaw is Flaw.FOREIGN


def test_a_member_that_is_longer_than_it_says_is_not_unpacked() -> None:
    data = bytearray(zipped({"a": b"x" * 100_000}))
    size = (100_000).to_bytes(4, "little")
    small = (10).to_bytes(4, "little")
    lying = bytes(data.replace(size, small))
    assert lying != data
    unpacker = Unpacker(lying)
    assert unpacker.sizes == {"a": 10}
    with pytest.raises(BadZip):
        unpacker.read("a")
