"""Runs the language chapters of this folder, `lang-*.md`: each program yields what stands below it.

A ```val2 block is compiled, or one named after another dialect; ```auto finds out which. What
follows it, up to the next program, is expected: ```diagnostics has one line each, `line:column
severity code headline`; without it there must be none. ```ir is the text dump of the module. The
prose says why.
"""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.ir.verify import verify
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, Dialect

CHAPTERS = sorted(Path(__file__).parent.glob("lang-*.md"))
FENCE = re.compile(r"^(#+ [^\n]*)$|^```([\w+]+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SAYS = "VAL-II says "


class Case(NamedTuple):
    """One program and what the compiler is to make of it."""

    title: str
    dialect: Dialect | None
    program: str
    expected: dict[str, str]


def cases() -> list[Case]:
    found: list[Case] = []
    for chapter in CHAPTERS:
        title = chapter.stem
        for match in FENCE.finditer(chapter.read_text("utf-8")):
            heading, language, text = match.groups()
            if heading:
                title = heading.lstrip("# ")
            elif language in DIALECTS or language == "auto":
                dialect = DIALECTS.get(language)
                found.append(Case(f"{chapter.stem}: {title}", dialect, text, {}))
            else:
                assert language in ("diagnostics", "controller", "ir"), language
                found[-1].expected[language] = text
    return found


def one_line(diagnostic: Diagnostic) -> str:
    span = diagnostic.primary.span if diagnostic.primary else None
    where = f"{span.line}:{span.column} " if span else ""
    return f"{where}{diagnostic.severity.value} {diagnostic.rule.code} {diagnostic.headline}"


def controller_says(diagnostics: tuple[Diagnostic, ...]) -> str:
    notes = (note for d in diagnostics for note in d.notes if note.startswith(SAYS))
    return "".join(note.removeprefix(SAYS) + "\n" for note in notes)


def test_there_are_chapters() -> None:
    assert len(cases()) > 70


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.title)
def test_program(case: Case) -> None:
    compilation = compile_source(SourceFile("spec.v2", case.program), Options(case.dialect))
    said = "".join(one_line(d) + "\n" for d in compilation.diagnostics)
    assert said == case.expected.get("diagnostics", "")
    if "controller" in case.expected:
        assert controller_says(compilation.diagnostics) == case.expected["controller"]
    if compilation.module is not None:
        assert verify(compilation.module) == []
    if "ir" in case.expected:
        assert compilation.module is not None
        assert dump(compilation.module) == case.expected["ir"]
