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


def test_a_piece_whose_faces_do_not_close_is_refused() -> None:
    """Six corners are within a rounding of one plane: gift wrapping leaves out a face of twelve."""
    corners = [
        (-46.68808530107438, -38.21730419614579, -49.73010038571027),
        (33.29980042891189, 0.057379158903751275, -49.73010581811323),
        (-0.8871046673834251, 35.109289451832026, 27.651132413584207),
        (4.87110200230296, -9.242377260082662, -49.73014093996918),
        (47.79087701098541, 12.185533650078186, -31.76526128038166),
        (47.481791432056944, 27.158127747536103, -49.73010420485696),
        (24.497637600367165, 38.431898514997236, -49.73017169216709),
        (-27.181126445140002, -22.56448438704954, -49.73017667878815),
    ]
    fields: dict[str, Any] = json.loads(u_pieces())
    fields["pieces_mm"].append(corners)
    with pytest.raises(PiecesFault, match="its faces are not sure"):
        read_pieces(json.dumps(fields).encode())
