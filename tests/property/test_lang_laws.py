"""Laws of the language: printing and parsing, layout, letter case, the order of sections."""

from hypothesis import given
from hypothesis import strategies as st

from tests.property.test_lang_never_raises import PROGRAM
from vrts.base.source import SourceFile
from vrts.ir.dump import dump, text_of
from vrts.ir.instructions import Assign
from vrts.lang.compiler import compile_source

NUMBERS = st.sampled_from(["0", "1", "2.5", "1000", "^17", ".25"])
ARITHMETIC = ["+", "-", "*", "/", "MOD"]
LOGICAL = ["AND", "OR", "XOR", "BAND", "BOR", "BXOR"]
INFIX = st.sampled_from([*ARITHMETIC, *LOGICAL, "==", "<>", "<", "<=", ">", ">="])
PREFIX = st.sampled_from(["-", "+", "NOT ", "COM "])
FUNCTIONS = st.sampled_from(["ABS", "SIN", "INT", "SIG"])
EXPRESSIONS = st.recursive(
    NUMBERS,
    lambda inner: st.one_of(
        st.tuples(inner, INFIX, inner).map(" ".join),
        st.tuples(PREFIX, inner).map("".join),
        inner.map(lambda e: f"({e})"),
        st.tuples(FUNCTIONS, inner).map(lambda e: f"{e[0]}({e[1]})"),
    ),
    max_leaves=12,
)


def value_of(expression: str) -> str | None:
    source = SourceFile("law.v2", f".PROGRAM main\nx = {expression}\n.END\n")
    module = compile_source(source).module
    if module is None:
        return None
    instruction = module.programs["main"].instructions[0]
    assert isinstance(instruction, Assign)
    return text_of(instruction.value)


def ir(text: str) -> str:
    compilation = compile_source(SourceFile("law.v2", text))
    assert compilation.module is not None, [d.headline for d in compilation.diagnostics]
    return dump(compilation.module)


@given(EXPRESSIONS)
def test_what_is_printed_parses_to_the_same(expression: str) -> None:
    printed = value_of(expression)
    if printed is not None and len(printed) < 240:  # longer than a line may be
        assert value_of(printed) == printed


@given(EXPRESSIONS)
def test_parentheses_round_the_whole_change_nothing(expression: str) -> None:
    if len(expression) < 230:
        assert value_of(f"({expression})") == value_of(expression)


@given(st.data())
def test_blanks_and_comments_change_nothing(data: st.DataObject) -> None:
    lines: list[str] = [*PROGRAM.split("\n")]
    for i, line in enumerate(lines):
        if line and not line.startswith("."):
            blanks = data.draw(st.sampled_from(["", "  ", "\t"]))
            comment = data.draw(st.sampled_from(["", " ; note", ";x = 1", '\t; "']))
            lines[i] = blanks + line + comment
    assert ir("\n".join(lines)) == ir(PROGRAM)


def test_letter_case_changes_nothing() -> None:
    plain = PROGRAM.replace('"a"', '"1"').replace('"x"', '"2"')
    assert ir(plain.upper()) == ir(plain) == ir(plain.lower())


def test_order_of_sections_changes_nothing_but_their_order() -> None:
    sections = [s + ".END\n" for s in PROGRAM.split(".END\n") if s]
    forward, backward = ir("".join(sections)), ir("".join(reversed(sections)))
    assert sorted(forward.split("\n\n")[0].split("\n")) == sorted(
        backward.split("\n\n")[1].split("\n")
    )
    assert set(forward.split("\n")) == set(backward.split("\n"))
