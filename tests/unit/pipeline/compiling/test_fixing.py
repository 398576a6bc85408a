"""Programs mended keep every byte that no fix names, whatever wrote them."""

import pytest

from tests.unit.pipeline.compiling.test_formatting import MARKS, WORDS
from vrts.pipeline.compiling.fixing import fix_bytes

WRONG = ".PROGRAM main\n  IF SIG(1) THEN READY ; {}\n ENDD ; {}\n  MOVEE part # {}\n.END\n"
RIGHT = ".PROGRAM main\n  IF SIG(1) THEN\n      READY ; {}\n END ; {}\n  MOVE part ; {}\n.END\n"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("codec", WORDS)
def test_every_encoding_and_line_end_stays(codec: str, end: str) -> None:
    def written(text: str) -> bytes:
        text = text.replace("{}", WORDS[codec]).replace("\n", end)
        return MARKS.get(codec, b"") + text.encode(codec)

    assert fix_bytes(written(WRONG), "a.v2").data == written(RIGHT)


def test_form_feeds_and_the_end_of_tapes_stay() -> None:
    wrong = b"\0\f.PROGRAM main\r\nMOVEE part\f\r\n.END\r\n\x1a"
    assert fix_bytes(wrong, "a.v2").data == wrong.replace(b"MOVEE", b"MOVE")


def test_right_programs_stay() -> None:
    data = b".PROGRAM main\nREADY\n.END\n"
    found = fix_bytes(data, "a.v2")
    assert (found.data, found.applied, found.left) == (data, (), ())


def test_no_fix_adds_an_error() -> None:
    for body in ("IF x THEN READY", "FOR i = 1 TO 3\n IF x THEN\n  READY\nEND", "}", "{", "end if"):
        found = fix_bytes(f".PROGRAM main\n{body}\n.END\n".encode(), "a.v2")
        before = fix_bytes(f".PROGRAM main\n{body}\n.END\n".encode(), "a.v2", passes=0)
        count = [sum(d.is_error for d in each.left) for each in (before, found)]
        assert count[1] <= count[0]
