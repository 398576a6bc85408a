"""A whole source in another language: headers, steps, comments and data."""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Severity, error
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.base.units import deg
from vrts.dispatch.posts.expressions_anew import CannotWrite, Settled
from vrts.dispatch.posts.kawasaki_as import KawasakiAs
from vrts.dispatch.posts.post import CANNOT_WRITE, LEFT_OUT, Post
from vrts.dispatch.posts.val2 import Val2
from vrts.dispatch.posts.vplus import VPlus
from vrts.ir.module import Datum
from vrts.lang.compiler import Compilation, Resolved, resolve_source
from vrts.lang.dialect import VAL2
from vrts.lang.names import key
from vrts.lang.reading.sections.lines import Section, comment_start
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import CallStatement, Declare
from vrts.lang.writing.layout import layout
from vrts.lang.writing.store import data_text
from vrts.robots.arms.primitives import degrees

POSTS: dict[str, type[Post]] = {post.name: post for post in (Val2, VPlus, KawasakiAs)}

_SAID_ONCE = 3  # places of a word that is left out, in one message


class Written(NamedTuple):
    """What a post made of a source."""

    text: str  # in canonical layout; as far as it could be written
    diagnostics: tuple[Diagnostic, ...]  # errors: what could not be; warnings: what was left out


@deep_stack()
def written(compilation: Compilation, target: str, settled: Settled) -> Written:
    """Return the programs and data of a compilation in the language of a post.

    Args:
        compilation: One that succeeded, of VAL-II or V+.
        target: A name of `POSTS`.
        settled: What the text depends on besides.
    """
    source, module = compilation.source, compilation.module
    assert source is not None
    assert module is not None
    found = resolve_source(source, compilation.dialect)
    assert found is not None
    writer = _Writer(POSTS[target](found, settled), found)
    post = writer.post
    raw = writer.programs() + data_text(writer.data(module.data), post.dialect)
    text = layout(SourceFile(source.name, raw), post.dialect)
    return Written(text, (*writer.errors, *_left_out(post)))


class _Writer:
    def __init__(self, post: Post, found: Resolved) -> None:
        self.post = post
        self.found = found
        self.problems = found.resolver.problems
        self.text = self.problems.source.text
        self.errors: list[Diagnostic] = []

    def programs(self) -> str:
        """Return all programs. Comments between them move into the one that follows."""
        rows: list[str] = []
        at = 0
        for program, section in zip(self.found.programs, self.found.sections, strict=True):
            between = self.text[at : section.header.start].split("\n")
            comments = [line.strip() for line in between if line.lstrip().startswith(";")]
            header, *steps = self._program(program, section)
            rows += (header, *comments, *steps)
            at = section.finish[1]
        return "".join(f"{row}\n" for row in rows)

    def data(self, given: Iterable[Datum]) -> list[Datum]:
        """Return the data, joint values as the other arm counts them."""
        found: list[Datum] = []
        for datum in given:
            if isinstance(datum.value, Pose) or not isinstance(datum.value, tuple):
                found.append(datum)
                continue
            try:
                arm = self.post.mapped(datum.span)
            except CannotWrite as cannot:
                self.errors.append(self._cannot(cannot))
                continue
            joints = arm.joints(tuple(map(deg, datum.value)))
            found.append(datum if arm.counts_alike else datum._replace(value=degrees(*joints)))
        return found

    def _begun(self, program: ProgramText) -> list[str]:
        """Return the steps that set the frames, where this is the program that is executed."""
        start = self.post.settled.start
        if start is None or program.name != start.program:
            return []
        called = (s.statement for p in self.found.programs for s in p.steps)
        for statement in called:
            if isinstance(statement, CallStatement) and key(statement.program.text) == program.name:
                headline = "the program that is executed is called too, and would set TOOL again"
                remedy = "write another program that only calls it, and execute that"
                cannot = CannotWrite(statement.start, statement.end, headline, remedy)
                self.errors.append(self._cannot(cannot))
        return [f"        {row}" for row in self.post.begun(start)]

    def _program(self, program: ProgramText, section: Section) -> list[str]:
        """Return a program from its header to its end."""
        self.post.program = program.name
        steps = {step.number: step for step in program.steps}
        rows = [self._header(program)]
        at = section.header.start
        if section.header.text:
            end = self._line_end(at)
            rows[0] += self._comment(self.text[at:end].rstrip("\n"))
            at = end
        begun = self._begun(program)
        for number in range(1, section.line_count + 1):
            end = self._line_end(at)
            statement = None if number not in steps else steps[number].statement
            if number in steps and not isinstance(statement, Declare):
                rows += begun
                begun = []
            rows += self._rows(steps.get(number), self.text[at:end].rstrip("\n"))
            at = end
        return [*rows, *begun, ".END"]

    def _header(self, program: ProgramText) -> str:
        formals = ", ".join(self.post.formal(formal) for formal in program.formals)
        bare = not formals and self.post.dialect is VAL2
        return f".PROGRAM {program.name}" + ("" if bare else f"({formals})")

    def _rows(self, step: Step | None, raw: str) -> list[str]:
        """Return the lines of one line of the source; its comment stays behind the first."""
        comment = self._comment(raw)
        if step is None:
            return [comment.strip()]
        label = "" if step.label is None else str(step.label.number)
        blanks = len(raw) - len(raw.lstrip())
        indent = f"{label} " if label else raw[:blanks].expandtabs()
        if step.statement is None:
            return [f"{indent}{comment}"]
        try:
            first, *more = self.post.statement(step.statement)
        except CannotWrite as cannot:
            self.errors.append(self._cannot(cannot))
            return [f"; {raw}"]
        return [f"{indent}{first}{comment}", *(" " * len(indent) + row for row in more)]

    def _comment(self, raw: str) -> str:
        """Return the comment of a line with blanks before it; empty where there is none."""
        cut = comment_start(raw)
        return f"  {raw[cut:].rstrip()}" if cut >= 0 else ""

    def _cannot(self, cannot: CannotWrite) -> Diagnostic:
        label = self.problems.label(cannot.start, cannot.end)
        return error(CANNOT_WRITE, cannot.headline, label, help=(cannot.remedy,))

    def _line_end(self, at: int) -> int:
        end = self.text.find("\n", at)
        return len(self.text) if end < 0 else end + 1


def _left_out(post: Post) -> tuple[Diagnostic, ...]:
    """Return one warning for each word that is left out."""
    problems = post.found.resolver.problems
    places: dict[str, list[tuple[int, int]]] = {}
    for start, end, word in post.left_out:
        places.setdefault(word, []).append((start, end))
    return tuple(
        Diagnostic(
            LEFT_OUT,
            Severity.WARNING,
            f"{post.dialect.title} has no {word}; it is left out",
            problems.label(*first),
            secondary=tuple(problems.label(*place, "and here") for place in more[:_SAID_ONCE]),
            notes=("the motion was compared, and is the same without it",),
        )
        for word, (first, *more) in places.items()
    )
