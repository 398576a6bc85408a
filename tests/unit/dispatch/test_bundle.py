"""Bundles: written the same each time, and opened without trusting them."""

import io
import zipfile
from collections.abc import Callable
from dataclasses import replace

import msgspec
import pytest

from vrts.dispatch.bundle import (
    MANIFEST,
    NO_MEMBERS,
    Bundle,
    bundle_bytes,
    content_digest,
    digest_of,
    read_bundle,
    rows,
    with_sheet,
)
from vrts.dispatch.manifest import WITHOUT_WISH, Manifest, Reads, Thing
from vrts.pipeline.refused import Refused

THING = Thing("x", "0" * 64)
LOCATIONS = ".LOCATIONS\na[1,2]          1.00 2.00 3.00 90.000 -90.000 0.000\n.END\n"


def made() -> Bundle:
    """Return a small bundle."""
    manifest = Manifest(
        WITHOUT_WISH,
        "0",
        "x.v2",
        "main",
        THING,
        THING,
        THING,
        None,
        "mark2-val2",
        "0" * 64,
        "val2",
        (),
        (),
        Reads((), (), ()),
        10.0,
        (),
        "",
        (),
        NO_MEMBERS,
    )
    programs = {"main": ".PROGRAM main()\n        READY\n.END\n"}
    return Bundle(manifest, programs, LOCATIONS, "", "", "<!doctype html>\n")


def members(data: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {info.filename: archive.read(info) for info in archive.infolist()}


def zipped(parts: dict[str, bytes], *, link: str = "") -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in parts.items():
            info = zipfile.ZipInfo(name)
            if name == link:
                info.external_attr = 0o120777 << 16
            archive.writestr(info, data)
    return buffer.getvalue()


def consistent(parts: dict[str, bytes]) -> dict[str, bytes]:
    """Return parts whose manifest lists them as they are: a forger can do that."""
    manifest = msgspec.json.decode(parts[MANIFEST])
    others = {name: data for name, data in sorted(parts.items()) if name != MANIFEST}
    manifest["files"] = [
        {"name": name, "sha256": digest_of(data), "bytes": len(data)}
        for name, data in others.items()
    ]
    return {MANIFEST: msgspec.json.encode(manifest), **others}


def test_what_is_written_is_read_and_the_same_bytes_come_out() -> None:
    bundle = made()
    data = bundle_bytes(bundle)
    again = read_bundle(data)
    assert dict(again.programs) == dict(bundle.programs)
    assert (again.locations, again.reals, again.strings) == (LOCATIONS, "", "")
    assert again.sheet == bundle.sheet
    assert again.profile == "mark2-val2"
    assert bundle_bytes(again) == data
    assert rows(again.locations) == (("a[1,2]", "1.00 2.00 3.00 90.000 -90.000 0.000"),)


def test_the_hash_of_what_is_sent_leaves_out_the_sheet_and_nothing_else() -> None:
    bundle = made()
    assert content_digest(with_sheet(bundle, "other\n")) == content_digest(bundle)
    assert content_digest(replace(bundle, locations="")) != content_digest(bundle)


def without(name: str) -> Callable[[dict[str, bytes]], dict[str, bytes]]:
    return lambda parts: {key: data for key, data in parts.items() if key != name}


def added(name: str, data: bytes) -> Callable[[dict[str, bytes]], dict[str, bytes]]:
    return lambda parts: {**parts, name: data}


PROGRAM = "programs/main.v2"


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (added(PROGRAM, b".PROGRAM main()\n        NEST\n.END\n"), "another length"),
        (added(PROGRAM, b".PROGRAM main()\n        REbDY\n.END\n"), "its hash is another"),
        (added("../evil", b"x\n"), "does not belong there"),
        (added("programs/../../evil.v2", b"x\n"), "does not belong there"),
        (added("programs/b.v2", b".PROGRAM b()\n.END\n"), "not those that its manifest lists"),
        (without("sheet.html"), "not there"),
        (without(MANIFEST), "missing"),
        (added(MANIFEST, b"{}"), "manifest.json"),
    ],
)
def test_a_changed_bundle_is_refused(
    change: Callable[[dict[str, bytes]], dict[str, bytes]], says: str
) -> None:
    parts = members(bundle_bytes(made()))
    with pytest.raises(Refused) as refused:
        read_bundle(zipped(change(parts)))
    (found,) = refused.value.diagnostics
    assert found.rule.code == "V800"
    assert says in found.headline


@pytest.mark.parametrize(
    "change",
    [
        added(PROGRAM, '.PROGRAM main()\n        TYPE "ä"\n.END\n'.encode()),
        added(PROGRAM, b".PROGRAM main()\n.END\n.PROGRAM other()\n.END\n"),
        added(PROGRAM, b".PROGRAM other()\n        READY\n.END\n"),
        added(PROGRAM, b".PROGRAM main()\r\n        READY\r\n.END\r\n"),
        added("locations.lc", b".LOCATIONS\n.REALS\n.END\n"),
        added("reals.rv", b".STRINGS\n$a b\n.END\n"),
        without(PROGRAM),
        without("sheet.html"),
    ],
)
def test_a_forged_manifest_does_not_help(
    change: Callable[[dict[str, bytes]], dict[str, bytes]],
) -> None:
    parts = consistent(change(members(bundle_bytes(made()))))
    with pytest.raises(Refused, match="errors"):
        read_bundle(zipped(parts))


def test_links_bombs_and_what_is_no_zip_are_refused() -> None:
    parts = members(bundle_bytes(made()))
    bomb = consistent({**parts, "sheet.html": b" " * 30_000_000})
    hostile = [b"", b"PK\x03\x04", zipped(parts, link=PROGRAM), zipped(bomb)]
    hostile += [bundle_bytes(made())[:-30], b"x" * 1000]
    for data in hostile:
        with pytest.raises(Refused):
            read_bundle(data)
