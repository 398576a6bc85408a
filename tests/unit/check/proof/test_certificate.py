"""Certificates as bytes: written, read again, and refused when anything about them is not right."""

import io
import json
import zipfile
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_proofs import case
from vrts.base.zips import packed
from vrts.check.proof import certificate
from vrts.check.proof.certificate import (
    COLUMNS,
    MANIFEST,
    OtherFormat,
    certificate_bytes,
    is_certificate,
    read_certificate,
    rounded,
)
from vrts.check.proof.checker import check
from vrts.check.proof.given import Wrong
from vrts.engine.storage.damage import Damaged

Change: TypeAlias = Callable[[dict[str, Any]], object]

SAID = {"program": "two cans", "scene": {"name": "cans"}}


def written(name: str = "free") -> bytes:
    claims, evidence, _ = case(name).certified
    return certificate_bytes(SAID, claims, evidence)


def members(data: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def repacked(data: bytes, changed: Mapping[str, bytes]) -> bytes:
    return packed({**members(data), **changed}, 0o600)


def retold(data: bytes, change: Change) -> bytes:
    said = json.loads(members(data)[MANIFEST])
    change(said)
    return repacked(data, {MANIFEST: json.dumps(said).encode()})


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["free", "contact", "fall", "serial"])
def test_what_is_written_is_read_again_and_holds(name: str) -> None:
    one = case(name)
    read = read_certificate(written(name))
    assert read.said["program"] == "two cans"
    assert read.claims == one.certified.claims
    for before, after in zip(one.certified.evidence.leaves, read.evidence.leaves, strict=True):
        assert np.array_equal(before, after)
    for before, after in zip(one.certified.evidence.points, read.evidence.points, strict=True):
        assert np.array_equal(before, after)
    assert check(one.scene, one.run, read.claims, read.evidence) == one.certified.proven


def test_the_same_certificate_is_the_same_bytes() -> None:
    assert written() == written()
    assert is_certificate(written())
    assert not is_certificate(b"PK\x03\x04 something else")


def test_directions_are_written_as_they_are_rounded() -> None:
    normal = np.random.default_rng(0).normal(size=(50, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    for step in certificate.STEPS:
        twice = rounded(rounded(normal, step), 1)
        assert np.array_equal(twice, rounded(normal, step))
        assert np.abs(twice - normal).max() <= step / certificate.ONE


def test_members_are_those_of_certificates() -> None:
    data = written()
    for name in (MANIFEST, *COLUMNS):
        rest = {k: v for k, v in members(data).items() if k != name}
        with pytest.raises(Damaged, match="members"):
            read_certificate(packed(rest, 0o600))
    with pytest.raises(Damaged, match="members"):
        read_certificate(repacked(data, {"more": b""}))
    with pytest.raises(Damaged, match="incomplete"):
        read_certificate(data[:-40])
    with pytest.raises(Damaged):
        read_certificate(b"no zip at all")


def formatted(data: bytes, number: int) -> bytes:
    return retold(data, lambda said: said.update(format=f"vrts.proof/{number}"))


@pytest.mark.parametrize(("number", "older"), [(1, True), (3, True), (5, False), (20, False)])
def test_another_format_is_named_before_anything_else_is_read(number: int, older: bool) -> None:
    parts = members(formatted(written(), number))
    del parts["files"], parts["edges"]
    with pytest.raises(OtherFormat, match=f"`vrts.proof/{number}`") as found:
        read_certificate(packed({**parts, "more": b""}, 0o600))
    assert found.value.older is older


@pytest.mark.parametrize("name", list(COLUMNS))
def test_columns_that_are_too_long_or_too_short_are_refused(name: str) -> None:
    data = written()
    column = members(data)[name]
    with pytest.raises((Damaged, Wrong)):
        believed(repacked(data, {name: column + column[-24:]}))
    with pytest.raises((Damaged, Wrong)):
        believed(repacked(data, {name: column[:-1]}))


def believed(data: bytes) -> None:
    one, read = case("free"), read_certificate(data)
    check(one.scene, one.run, read.claims, read.evidence)


def test_limits_hold_before_anything_is_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    data = written()
    monkeypatch.setattr(certificate, "MOST_BYTES", 1000)
    with pytest.raises(Damaged, match="too large"):
        read_certificate(data)
    monkeypatch.undo()
    for limit in ("MOST_LEAVES", "MOST_EDGES", "MOST_POINTS", "MOST_MANIFEST"):
        monkeypatch.setattr(certificate, limit, 1)
        with pytest.raises(Damaged):
            read_certificate(data)
        monkeypatch.undo()
    with pytest.raises(Damaged, match="files of its scene are too large"):
        read_certificate(repacked(data, {"files": b"\0" * (certificate.MOST_FILES + 1)}))
    bomb = repacked(data, {"corners": b"\0" * (certificate.MOST_BYTES + 8)})
    assert len(bomb) < 200_000
    with pytest.raises(Damaged, match="too large"):
        read_certificate(bomb)


def test_numbers_that_are_none_are_refused() -> None:
    data = written()
    for name in ("edges", "time", "corners", "weights"):
        column = bytearray(members(data)[name])
        column[:8] = np.array([np.nan]).tobytes()
        with pytest.raises(Damaged, match="infinite"):
            read_certificate(repacked(data, {name: bytes(column)}))


CHANGES: list[Change] = [
    lambda said: said.update(format="vrts.proof/0"),
    lambda said: said.pop("format"),
    lambda said: said.update(program="three cans"),
    lambda said: said.update(more="unhashed"),
    lambda said: said["sha256"].pop("scene"),
    lambda said: said.update(files=[["arm.urdf", 3]]),
    lambda said: said.update(sha256=[]),
    lambda said: said.update(claims=None),
    lambda said: said["claims"].update(contacts=3),
    lambda said: said["claims"].update(contacts=[["robot", "can1", 0.0]]),
    lambda said: said["claims"].update(contacts=[["robot", 1, 0.0, 1.0]]),
    lambda said: said["claims"].update(clearance_m="far"),
    lambda said: said["claims"].update(clearance_m=True),
    lambda said: said["claims"].update(near_miss_m="far"),
    lambda said: said["claims"].update(near_miss_m=[0.005]),
    lambda said: said["claims"].update(let_go=[["can1", 0.5, 0, 0.0, 0.0]]),
    lambda said: said["claims"].update(parted=[[]]),
]


@pytest.mark.parametrize("change", CHANGES)
def test_what_a_certificate_says_of_itself_is_read_without_trust(
    change: Change,
) -> None:
    with pytest.raises(Damaged):
        read_certificate(retold(written(), change))


@pytest.mark.thorough
@settings(max_examples=examples(60), deadline=None)
@given(st.data())
def test_no_altered_byte_is_an_exception_or_proves_something_else(data: st.DataObject) -> None:
    """Bytes of a column, or of the whole file: refused, or what is proven is the same."""
    name = data.draw(st.sampled_from(["free", "contact", "fall", "again"]))
    one, whole = case(name), written(name)
    which = data.draw(st.sampled_from([None, *COLUMNS, MANIFEST]))
    bytes_ = bytearray(whole if which is None else members(whole)[which])
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(bytes_) - 1))
        bytes_[at] = data.draw(st.integers(0, 255))
    altered = bytes(bytes_) if which is None else repacked(whole, {which: bytes(bytes_)})
    try:
        read = read_certificate(altered)
        check(one.scene, one.run, read.claims, read.evidence)
    except (Damaged, Wrong):
        return
    meant, told = one.certified.claims, read.claims
    assert [m[:2] for m in told.meetings] == [m[:2] for m in meant.meetings]
    for a, b in zip(told.meetings, meant.meetings, strict=True):
        assert a[2:] == pytest.approx(b[2:], abs=0.5)
    if meant.clearance_m is not None:
        assert told.clearance_m == pytest.approx(meant.clearance_m, abs=5e-4)
