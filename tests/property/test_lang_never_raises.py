"""Whatever is handed in is answered by a module or by diagnostics, never by an exception."""

from hypothesis import given
from hypothesis import strategies as st

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.ir.verify import verify
from vrts.lang.compiler import Compilation, compile_source
from vrts.lang.problems import LIMIT
from vrts.lang.reading import decode
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

WORDS = [*INSTRUCTIONS, *OPERATORS, *QUALIFIERS, "a", "b", "$s", "#p", "part", "TRANS", "DX"]
SIGNS = [*"=+-*/<>()[],:;.'^/%$#&!", '"', "==", "<>", "=<", ":=", "“", "”", "–", "ö", "\u00a0"]
NUMBERS = ["0", "1", "10", "3.5", "1E3", "1E99", "^17", "^H", "/F8.2", "/I0", "'A", '"text"']
TOKENS = st.sampled_from([*WORDS, *SIGNS, *NUMBERS])

PROGRAM = """.PROGRAM main(a, $s, v[])
        OPENI
        FOR i = 1 TO 4 STEP 2
            CALL pick(i, part, , v[])
            IF (i == 2) AND NOT SIG(1001, -2) THEN
                TYPE "a", /F8.2, i*2+1, $s+"x", /S
            ELSE
                GOTO 10
            END
        END
10      CASE i OF
          VALUE 1, 2:
            READY
          ANY
            v[1] = a MOD 3
        END
        WHILE a < 3 DO
            a = a+1
        END
        DO
        UNTIL SIG(1001)
        SET tray[2] = frame:SHIFT(part BY 0,,10):TRANS(1,2,3,,,9)
        HERE frame:part
        BASE ,,300
        SPEED 50 MMPS ALWAYS
.END
.PROGRAM pick(n, l, x, q[])
        APPRO l, 60
        MOVES l
        CLOSEI
        DEPARTS 60
.END
.LOCATIONS
part            450.0 -120.0 -50.0 90.0 90.0 0.0
#safe           0 -90 90 0 0 0
.END
"""


def check(compilation: Compilation) -> None:
    if compilation.module is None:
        assert any(d.is_error for d in compilation.diagnostics)
    else:
        assert not any(d.is_error for d in compilation.diagnostics)
        assert verify(compilation.module) == []
        assert dump(compilation.module)
    assert len(compilation.diagnostics) <= LIMIT + 1
    for d in compilation.diagnostics:
        assert d.headline
        assert d.headline[-1] != "."
        for label in (d.primary, *d.secondary):
            if label is not None:
                start, end = label.span.start, label.span.end
                assert 0 <= start <= end <= len(label.span.source.text)
                assert "\n" not in label.span.text


def compile_text(text: str) -> Compilation:
    return compile_source(SourceFile("test.v2", text))


def test_the_program_itself_compiles() -> None:
    assert compile_text(PROGRAM).module is not None


@given(st.binary(max_size=300))
def test_any_bytes(data: bytes) -> None:
    source = decode(data, "test.v2")
    if not isinstance(source, Diagnostic):
        check(compile_source(source))


@given(st.text(max_size=300))
def test_any_text(text: str) -> None:
    check(compile_text(text))


@given(st.lists(st.lists(TOKENS, max_size=10), max_size=12), st.sampled_from(["", " "]))
def test_token_soup(lines: list[list[str]], glue: str) -> None:
    body = "\n".join(glue.join(line) for line in lines)
    check(compile_text(f".PROGRAM main(a)\n{body}\n.END\n"))


@given(st.data())
def test_mutated_program(data: st.DataObject) -> None:
    text = PROGRAM
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(len(text), start + 12)))
        inserted = data.draw(st.one_of(TOKENS, st.just("\n"), st.just("")))
        text = text[:start] + inserted + text[end:]
    check(compile_text(text))


@given(st.permutations(PROGRAM.split("\n")))
def test_shuffled_lines(lines: list[str]) -> None:
    check(compile_text("\n".join(lines)))
