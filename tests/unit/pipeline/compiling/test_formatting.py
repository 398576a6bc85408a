"""A file laid out anew keeps every byte that is not layout, whatever wrote it."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from vrts.lang.reading.encodings import characters
from vrts.pipeline.compiling.formatting import format_bytes

UGLY = '.program main\nmove P ; {}\n  TYPE "{}",x\n; {}\n.end\n'
NEAT = '.PROGRAM main\n        MOVE p  ; {}\n        TYPE "{}", x\n; {}\n.END\n'
WORDS = {  # encodings of controllers' PCs, and what was written in them
    "cp1250": "Příliš žluťoučký kůň",
    "cp1251": "Взять деталь",
    "cp1252": "Greifer öffnen, Straße",
    "cp1253": "Άνοιξε την αρπάγη",
    "cp437": "Größe ½ «»",
    "cp850": "opérateur à côté",
    "koi8-r": "Взять деталь",
    "iso8859-2": "łapka otwórz",
    "shift_jis": "ハンドを開く 表示ソ能",
    "euc-jp": "ハンドを開く",
    "euc-kr": "손을 연다",
    "gb18030": "打开夹爪",
    "big5": "打開夾爪 功許蓋",
    "utf-8": "Greifer öffnen 打开 🤖",
    "utf-16-le": "Greifer öffnen 打开 🤖",
    "utf-16-be": "Greifer öffnen 打开 🤖",
}
MARKS = {"utf-8": b"\xef\xbb\xbf", "utf-16-le": b"\xff\xfe", "utf-16-be": b"\xfe\xff"}


def formatted(data: bytes, dialect: str = "val2") -> bytes:
    found = format_bytes(data, "a.v2", dialect)
    assert found.diagnostic is None
    assert format_bytes(found.data, "a.v2", dialect).data == found.data
    assert found.changed is (found.data != data)
    return found.data


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize(
    ("codec", "mark"), [*((codec, b"") for codec in WORDS), *MARKS.items()], ids=str
)
def test_every_encoding_comes_out_as_it_went_in(codec: str, mark: bytes, end: str) -> None:

    def written(text: str) -> bytes:
        return mark + text.replace("{}", WORDS[codec]).replace("\n", end).encode(codec)

    assert formatted(written(UGLY)) == written(NEAT)
    assert formatted(written(NEAT)) == written(NEAT)


def test_every_line_keeps_its_own_end() -> None:
    data = b".program a\r\nmove P\nmove Q\rmove R\r\n.end"
    move = b"        MOVE "
    assert formatted(data) == b".PROGRAM a\r\n%sp\n%sq\r%sr\r\n.END" % (move, move, move)


def test_what_disks_and_paper_tape_had_stays() -> None:
    data = b"\0\0\f.program a\r\nmove P\f\r\n\f\r\n.end\r\n\x1a\x1a\0"
    neat = b"\0\0\f.PROGRAM a\r\n        MOVE p\f\r\n\f\r\n.END\r\n\x1a\x1a\0"
    assert formatted(data) == neat
    within = b".program a\nmo\0ve P\n.end\n"
    assert formatted(within) == b".PROGRAM a\nmo\0ve P\n.END\n"


def test_half_a_character_at_the_end_stays() -> None:
    data = b"\xff\xfe" + ".program a\nmove P\n.end\n".encode("utf-16-le") + b"\x41"
    neat = b"\xff\xfe" + ".PROGRAM a\n        MOVE p\n.END\n".encode("utf-16-le") + b"\x41"
    assert formatted(data) == neat


FOREIGN = st.binary(max_size=12).map(lambda data: data.translate(None, b'\r\n\0\f\x1a;"'))
SOUND = st.binary(max_size=8).map(lambda data: data.translate(None, bytes(range(32)) + b'"'))


@given(FOREIGN, SOUND)
@example(b"\xff\xfe", b"\x81\x8d\x8f\x90\x9d\xa0")
@example(b" \xa0", b"\xa0")
@example(b"\x83\x5c", b"\x95\x5c")
def test_any_bytes_of_comments_and_strings_stay(comment: bytes, string: bytes) -> None:
    data = b'.program a\r\nmove P ;%s\r\ntype "%s"\r\n;%s\r\n.end\r\n' % (comment, string, comment)
    read = characters(data)
    if read is None:
        return  # so many control characters are no text
    said = comment.rstrip(b" \t")
    neat = b'.PROGRAM a\r\n        MOVE p  ;%s\r\n        TYPE "%s"\r\n;%s\r\n.END\r\n'
    assert formatted(data) == neat % (said, string, said)


@given(st.binary(max_size=200))
@example(b"\xef\xbb\xbf\xef\xbb\xbf;\n")
@example(b"\xff\xfe\x00\xd8;\x00\n\x00")
def test_characters_become_the_bytes_that_they_were(data: bytes) -> None:
    found = characters(data)
    assert found is None or found.encoding.encode(found.text) == data


@given(st.binary(max_size=120))
def test_nothing_that_can_be_read_is_lost(data: bytes) -> None:
    found = format_bytes(data, "a.v2", "val2")
    if found.diagnostic is None:
        kept = bytes(byte for byte in found.data if byte > 32).lower()
        assert kept == bytes(byte for byte in data if byte > 32).lower()


FORMS = [
    ("as", ".PROGRAM a(.$msg,&b)"),
    ("val2", ".PROGRAM a(.$msg)"),
    ("vplus", ".PROGRAM a(.$msg, &b)"),
    ("as", "        POINT/OAT p = q"),
    ("as", "        POINT /OAT p = q"),
    ("as", "        POINT/X p = q"),
    ("as", "        POINT /X p = q"),
    ("as", '        TYPE/S "a"'),
]


@pytest.mark.parametrize(("dialect", "line"), FORMS)
def test_forms_of_a_relative_keep_their_signs(dialect: str, line: str) -> None:
    program = "" if line.startswith(".") else ".PROGRAM main\n"
    text = f"{program}{line}\n.END\n"
    assert formatted(text.encode(), dialect).decode() == text


def test_lines_that_cannot_be_read_are_counted() -> None:
    found = format_bytes(b".program a\nmoove p\nmove P\nx = (1\n.end\n", "a.v2", "val2")
    assert found.unread == (2, 4)
    assert format_bytes(b"garbage", "a.v2", None).unread == (1,)
    assert format_bytes(b".program a\nmove P\n.end\n", "a.v2", None).unread == ()
