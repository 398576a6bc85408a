"""What the page is told has a shape: nothing foreign turns around what stands beside it."""

import json

import msgspec

from vrts.desk.front.shapes import with_shapes

PLAIN = {"name": "Çelik 小龍", "text": "two\nlines\tand \\\\u202e, \\\\b as typed", "mark": 7.5}


def through(value: object) -> object:
    return json.loads(with_shapes(msgspec.json.encode(value)))


def test_marks_of_direction_and_control_characters_become_stand_ins() -> None:
    found = through(
        {"text": "pass\u202eliaf\u2069 x\x07y\x7f\u2028z\r\b", "\u200b": ["\U000e0001"]}
    )
    assert found == {"text": "pass�liaf� x␇y␡�z␍␈", "�": ["�"]}


def test_everything_else_stays_as_it_is() -> None:
    assert through(PLAIN) == PLAIN
    assert through({**PLAIN, "odd": "\u202e"}) == {**PLAIN, "odd": "�"}
    data = msgspec.json.encode({"name": "Çelik"})
    assert with_shapes(data) is data
