"""Every rule has its page, every page its rule; the examples of the language trigger their code."""

import re
from importlib.resources import files

import pytest

from tests.unit.rules import of_programs, rules
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, VAL2
from vrts.lang.reading.decoding import decode
from vrts.lang.typed.execute_line import parse_command

PAGES = files("vrts").joinpath("pages")
TITLE = re.compile(r"# (V\d{3}) ([a-z0-9-]+)\n")
FENCE = re.compile(r"```([\w+]+)\n(.*?)\n```", re.DOTALL)

# What no page can show as text: bytes that trigger the code.
BYTES = {
    "V101": b" \n",
    "V102": b"%PDF-1.7\n",
    "V103": b"x" * 4_000_001,
    "V116": b".PROGRAM main\n" + (b"x = 1" + b"+1" * 60 + b"\n") * 8_400 + b".END\n",
    "V115": b".PROGRAM main\n" + b"READY\n" * 65_001 + b".END\n",
}
# What cannot but come along: such examples are long lines, or many faults.
ALONG = {"V113": {"V106"}, "V114": {"V106"}, "V151": {"V120"}}


def pages() -> dict[str, str]:
    return {
        page.name.removesuffix(".md"): page.read_text("utf-8")
        for page in PAGES.iterdir()
        if page.name.endswith(".md")
    }


def test_rules_and_pages_belong_together() -> None:
    assert sorted(rules()) == sorted(pages())


def test_a_code_stands_for_one_rule() -> None:
    assert {code: slugs for code, slugs in rules().items() if len(slugs) > 1} == {}


@pytest.mark.parametrize("code", sorted(pages()))
def test_page_has_title_and_example(code: str) -> None:
    text = pages()[code]
    title = TITLE.match(text)
    assert title is not None
    assert title[1] == code
    assert [slug for slug, _ in rules()[code]] == [title[2]]
    assert FENCE.search(text)


@pytest.mark.parametrize("code", [c for c in sorted(pages()) if of_programs(c)])
def test_example_triggers_the_code(code: str) -> None:
    example = FENCE.search(pages()[code])
    assert example is not None
    source = decode(BYTES.get(code, example[2].encode()), "example.v2")
    if isinstance(source, Diagnostic):
        assert source.rule.code == code
        return
    if example[1] == "text" and code not in BYTES:
        _, diagnostics = parse_command(source)
        assert [d.rule.code for d in diagnostics] == [code]
        return
    dialect = None if example[1] == "auto" else DIALECTS.get(example[1], VAL2)
    compiled = compile_source(SourceFile("example.v2", source.text), Options(dialect))
    found = [d.rule.code for d in compiled.diagnostics]
    assert code in found
    unused = {"V225"} - {code}  # examples of two lines seldom use what they compute
    assert set(found) - ALONG.get(code, set()) - unused == {code}
