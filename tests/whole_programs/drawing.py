"""Programs drawn by chance, from a number: the same number gives the same program."""

import re
from random import Random
from typing import NamedTuple

from tests.whole_programs.settings import SCENES, drawn_scenario, section
from tests.whole_programs.vocabulary import (
    BESIDE,
    BLOCKS,
    EXPRESSIONS,
    HOLE,
    STATEMENTS,
    SUBROUTINES,
    bare,
    known,
    parts,
)
from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.scene.model import Scenario

# by the last digit of a number; every word of the relatives counts in the first
ORDER = ("val2+", "val2", "val2+", "vplus", "val2+", "as", "val2+", "val2", "val2+", "val2+")
DEPTH = 3  # of expressions and blocks
TURN = 8  # statements that a program has because it is their turn
LABELS = range(10, 100, 10)
# words after which little else may be reached
ENDS = {"HALT", "STOP", "PAUSE", "RETURN", "RETURNE", "GOTO", "MOVE", "DISABLE", "x", "n"}
MENDED = 8  # times that steps with faults are taken out
GIVEN = """
n = 0 ; i = 1 ; x = 0.5 ; y = -2 ; z = 0 ; g = 0 ; m[0] = 1 ; m[1] = 2 ; m[2] = 3 ; $s = "a,b,c" ;
$t = "xy" ; $a[0] = "first" ; $a[1] = "second" ; $a[2] = ""
"""


class Drawn(NamedTuple):
    """A program, where it is executed, and what happens meanwhile."""

    number: int
    text: str
    dialect: str
    scene: str
    scenario: Scenario


def drawn(number: int) -> Drawn:
    """Return the program of a number; it compiles."""
    for attempt in range(100):
        draw = Random(f"{number}.{attempt}")
        dialect = ORDER[number % len(ORDER)]
        scene = SCENES[number % len(SCENES)]
        text = _Writer(draw, dialect, scene).file(number)
        mended = _compiling(text, dialect)
        if mended is not None:
            return Drawn(number, mended, dialect, scene, drawn_scenario(draw, scene))
    raise AssertionError(f"no program of number {number} compiles")


def _ordinal(number: int) -> int:
    """Return how many programs with smaller numbers are of the same dialect."""
    rounds, k = divmod(number, len(ORDER))
    return rounds * ORDER.count(ORDER[k]) + ORDER[:k].count(ORDER[k])


def _compiling(text: str, dialect: str) -> str | None:
    """Return a text without the lines that have faults; None when others are left."""
    for _ in range(MENDED):
        found = compile_source(SourceFile("main.v2", text), Options(DIALECTS[dialect]))
        if found.module is not None:
            return text
        errors = [d for d in found.diagnostics if d.is_error and d.primary is not None]
        wrong = {d.primary.span.line for d in errors if d.primary is not None}
        lines = text.split("\n")
        keep = [line for k, line in enumerate(lines, 1) if k not in wrong or line.startswith(".")]
        if len(keep) == len(lines):
            return None
        text = "\n".join(keep)
    return None


class _Writer:
    """Writes one file."""

    def __init__(self, draw: Random, dialect: str, scene: str) -> None:
        self.draw, self.dialect, self.scene = draw, dialect, scene
        self.statements = [part for part in parts(STATEMENTS) if known(part, dialect)]
        self.blocks = [part for part in parts(BLOCKS) if known(part, dialect)]
        self.free = list(LABELS)  # labels that no step of the program has yet

    def file(self, number: int) -> str:
        """Return a file of several programs and their places."""
        turn, begin = self.statements, TURN * _ordinal(number)
        own = [part for part in turn if part.startswith("[only")]
        own += [turn[(begin + k) % len(turn)] for k in range(TURN)]
        own.sort(key=lambda part: part.split()[0] in ENDS)  # what ends the program comes last
        beside = [part for part in parts(BESIDE) if known(part, self.dialect)]
        called = [part for part in parts(SUBROUTINES) if known(part, self.dialect)]
        given = [part for part in GIVEN.split(";") if self.draw.random() > 0.02]
        draw = self.draw
        if draw.random() < 0.8:
            given.append("REACTE err")
        body = [*given, *self.body(own, draw.randint(4, 22))]
        programs = [self.program("main", body)]
        programs.append(self.program("b", self._of(beside, draw.randint(0, 7))))
        programs.append(self.program("sub(a1, a2)", self._of(called, draw.randint(0, 4))))
        programs.append(self.program("list(c1[], $c2)", ["c1[5] = 7", *self._of(called, 1)]))
        programs.append(self.program("r1", self._of([*self.statements, *called], 2)))
        programs.append(self.program("r2", self._of(called, 2)))
        ends = draw.choice([*["RETURNE"] * 8, "RETURN", "n = n+1"])
        programs.append(self.program("err", [*self._of(called, 1), ends]))
        return "\n".join([*programs, section(self.scene, self.dialect)])

    def program(self, head: str, body: list[str]) -> str:
        """Return the text of a program."""
        rows = [row.strip() for part in body for row in part.split(";")]
        gone = [k for k in LABELS[:4] if k in self.free and re.search(rf"\b{k}\b", "\n".join(rows))]
        rows += [f"{label} n = n" for label in gone]
        self.free = list(LABELS)
        return "\n".join([f".PROGRAM {head}", *rows, ".END"])

    def body(self, first: list[str], count: int) -> list[str]:
        """Return statements, some of which have labels, beginning with those whose turn it is."""
        found: list[str] = []
        for k in range(max(count, len(first))):
            pool = self.blocks if self.draw.random() < 0.2 and self.blocks else self.statements
            template = first[k] if k < len(first) else self.draw.choice(pool)
            found.append(self._labelled(self.filled(template, 0)))
        return found

    def filled(self, template: str, depth: int) -> str:
        """Return a template with its holes filled."""
        template = bare(template)
        found = HOLE.search(template)
        while found is not None:
            template = (
                template[: found.start()] + self._one(found[1], depth) + template[found.end() :]
            )
            found = HOLE.search(template)
        return template

    def _of(self, pool: list[str], count: int) -> list[str]:
        return [
            self._labelled(self.filled(self.draw.choice(pool), 1))
            for _ in range(count if pool else 0)
        ]

    def _one(self, hole: str, depth: int) -> str:
        if hole == "k":
            return str(self.draw.choice(LABELS[:4]))
        if hole == "B":
            count = self.draw.randint(1, 3 - min(depth, 2))
            pool = self.statements if depth >= DEPTH - 1 else [*self.statements, *self.blocks]
            return " ; ".join(self.filled(self.draw.choice(pool), depth + 1) for _ in range(count))
        choices = [part for part in parts(EXPRESSIONS[hole]) if known(part, self.dialect)]
        if depth >= DEPTH:
            choices = [part for part in choices if "(" not in part and "/" not in part] or choices
        return self.filled(self.draw.choice(choices), depth + 1)

    def _labelled(self, statement: str) -> str:
        if self.free and self.draw.random() < 0.2 and not statement.startswith(("f ", "h ")):
            return f"{self.free.pop(0)} {statement}"
        return statement
