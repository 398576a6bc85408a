"""Which of the files of a hand-in is the program."""

from collections.abc import Callable, Collection, Sequence
from pathlib import PurePosixPath
from typing import NamedTuple

from vrts.marking.intake.candidate import Candidate
from vrts.marking.intake.given import essence
from vrts.marking.intake.row import Kind, Problem
from vrts.marking.intake.tree.file_names import copy_of, is_note, is_program_name, same_name

NOTHING = Problem(Kind.MISSING, "nothing was handed in")
GIVEN = "what students were given"
SHOWN = 4  # files named in a sentence

# what is told where nothing can be marked: the first of these that is there
_TELLING = (Kind.UNREADABLE, Kind.NOT_TEXT, Kind.ARCHIVE, Kind.TOO_LARGE, Kind.EMPTY)


class Choice(NamedTuple):
    """The file that was chosen, and why; without one, what the matter is."""

    file: str | None
    why: str
    others: tuple[str, ...]
    problem: Problem | None = None
    copies: tuple[str, ...] = ()  # earlier copies of the file, in order


def choose(
    found: Sequence[Candidate],
    program: str | None,
    *,
    canvas: bool = False,
    given: Collection[str] = (),
) -> Choice:
    """Choose among the files of a hand-in.

    The one that has the program of the task; else the one that reads as VAL-II; else the only
    text. Files with the same text count as one, and of numbered copies the latest is taken. What
    students were given counts only where there is nothing else.

    Args:
        found: Every file.
        program: Name of the program that the task runs; None: any.
        canvas: Copies are numbered as Canvas does it.
        given: Programs that students were given, as `essence` tells them.
    """
    if not found:
        return Choice(None, "no file", (), NOTHING)
    texts = [candidate for candidate in found if candidate.problem is None]
    name = program.lower() if program else None
    for fits, why in _rules(name):
        fitting = [candidate for candidate in texts if fits(candidate)]
        if not fitting:
            continue
        own = [candidate for candidate in fitting if essence(candidate.text) not in given]
        if given and own and len(own) < len(fitting):
            fitting, why = own, f"{why} and is not {GIVEN}"
        choice = _among(fitting, found, why, canvas=canvas)
        if name is not None and fits is _plausible and len(found) > 1:
            choice = choice._replace(why=f"{choice.why}; no file has `.PROGRAM {name}`")
        return choice
    return _unmarkable(found)


Rule = tuple[Callable[[Candidate], bool], str]


def _rules(name: str | None) -> tuple[Rule, ...]:
    named: tuple[Rule, ...] = ()
    if name is not None:
        named = ((lambda c: name in c.programs, f"has `.PROGRAM {name}`"),)
    return (*named, (_plausible, "reads as VAL-II"), (_named_as_program, "is named as a program"))


def _plausible(candidate: Candidate) -> bool:
    return candidate.plausible


def _named_as_program(candidate: Candidate) -> bool:
    return is_program_name(candidate.file)


def _among(
    fitting: list[Candidate], found: Sequence[Candidate], why: str, *, canvas: bool
) -> Choice:
    """Choose among files that fit equally well."""
    if len(found) == 1:
        return Choice(found[0].file, "the only file", ())
    chosen, copies, reason = _settled(fitting, canvas=canvas)
    if chosen is None:
        names = _listed([candidate.file for candidate in fitting])
        problem = Problem(
            Kind.AMBIGUOUS, f"{len(fitting)} files fit, and nothing says which: {names}"
        )
        return Choice(None, why, tuple(c.file for c in found), problem)
    others = tuple(c.file for c in found if c is not chosen)
    only = "the only file that " if len(fitting) == 1 else ""
    return Choice(chosen.file, f"{only}{why}{reason}", others, None, copies)


def _settled(
    fitting: list[Candidate], *, canvas: bool
) -> tuple[Candidate | None, tuple[str, ...], str]:
    """Return the one to take, earlier copies of it, and why; None where nothing tells."""
    if len(fitting) == 1:
        return fitting[0], (), ""
    if len({candidate.text for candidate in fitting}) == 1:
        return min(fitting, key=_plainness), (), ", as others with the same text"
    numbered = [(*copy_of(candidate.file, canvas=canvas), candidate) for candidate in fitting]
    if len({same_name(name) for name, _, _ in numbered}) == 1:
        numbered.sort(key=lambda entry: entry[1])
        copies = tuple(candidate.file for _, _, candidate in numbered[:-1])
        return numbered[-1][2], copies, ", the latest of its copies"
    named = [candidate for candidate in fitting if is_program_name(candidate.file)]
    if len(named) == 1:
        return named[0], (), " and is named as a program"
    return None, (), ""


def _plainness(candidate: Candidate) -> tuple[int, int, str]:
    return candidate.file.count("/"), len(candidate.file), candidate.file


def _unmarkable(found: Sequence[Candidate]) -> Choice:
    """Say what the matter is where no file is a program."""
    texts = [c for c in found if c.problem is None and not is_note(c.file)]
    if len(texts) == 1:
        others = tuple(c.file for c in found if c is not texts[0])
        return Choice(texts[0].file, "the only text" if others else "the only file", others)
    if texts:
        names = _listed([candidate.file for candidate in texts])
        sentence = f"{len(texts)} texts, none of which reads as VAL-II: {names}"
        problem = Problem(Kind.AMBIGUOUS, sentence)
        return Choice(None, "no file is a program", tuple(c.file for c in found), problem)
    for kind in _TELLING:
        for candidate in found:
            if candidate.problem is not None and candidate.problem.kind is kind:
                others = tuple(c.file for c in found if c is not candidate)
                return Choice(candidate.file, "no file is a program", others, candidate.problem)
    names = _listed([candidate.file for candidate in found])
    problem = Problem(Kind.MISSING, f"nothing was handed in but {names}")
    return Choice(None, "no file is a program", tuple(c.file for c in found), problem)


def _listed(files: list[str]) -> str:
    shown = ", ".join(f"`{PurePosixPath(file).name}`" for file in sorted(files)[:SHOWN])
    return f"{shown} and {len(files) - SHOWN} more" if len(files) > SHOWN else shown
