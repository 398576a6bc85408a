"""Files of pieces: written and read alike, and refused where they are odd."""

import json
from typing import Any

import pytest

from tests.parts import u_pieces
from vrts.scene.meshes.pieces_file import PiecesFault, pieces_text, read_pieces


def test_what_is_written_is_what_is_read() -> None:
    assert pieces_text(read_pieces(u_pieces())).encode() == u_pieces()


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("format", "vrts pieces 9"),
        ("mesh", 5),
        ("unit", "x" * 300),
        ("most", True),
        ("at_most_mm", "wide"),
        ("found_mm", float("nan")),
        ("found_mm", 10**400),
        ("centre_of_mass_mm", [1, 2]),
        ("centre_of_mass_mm", [1, 2, 1e9]),
        ("pieces_mm", []),
        ("pieces_mm", [[[0, 0, 0]]]),
        ("pieces_mm", [[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]]),
        ("pieces_mm", [[[0, 0, 0]] * 401]),
        ("pieces_mm", [[[0, 0, 0]] * 4] * 65),
        ("pieces_mm", "many"),
    ],
)
def test_odd_files_are_refused(key: str, value: object) -> None:
    fields: dict[str, Any] = json.loads(u_pieces())
    fields[key] = value
    with pytest.raises(PiecesFault):
        read_pieces(json.dumps(fields).encode())


@pytest.mark.parametrize("data", [b"", b"\xff", b"[" * 100_000, b"[]", b"{}", b"PK\x03\x04"])
def test_what_is_no_file_of_pieces_is_refused(data: bytes) -> None:
    with pytest.raises(PiecesFault):
        read_pieces(data)
