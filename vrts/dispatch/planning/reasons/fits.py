"""What only matters on the controller: characters, lengths of lines and names, memory, words."""

import re
from collections.abc import Iterator, Mapping

from vrts.base.diagnostic import Diagnostic, error
from vrts.base.pose import Pose
from vrts.dispatch.planning.printed import Printed, placed_data
from vrts.dispatch.planning.reasons.refusals import (
    LINE_TOO_LONG,
    MEMORY_FULL,
    NAME_TOO_LONG,
    NOT_TYPABLE,
    WORD_MISSING,
)
from vrts.dispatch.profile import Profile
from vrts.dispatch.steps import typed
from vrts.ir.expressions import Global
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.lang.names import NAME_TRUNCATED

POSE_BYTES, JOINTS_BYTES, REAL_BYTES = 48, 24, 4  # twelve, six, one number of 4 bytes [assumed]
STRING_BYTES = 128  # its longest [assumed]
ENTRY_BYTES = 20  # of a name and what leads to its value [assumed]
FEW = 3  # lines named in a message

_WORD = re.compile(r"[A-Z][A-Z0-9.]*")
_QUIET = re.compile(r'"[^"]*"|;.*')  # strings and comments


def fits(texts: Printed, module: Module, profile: Profile) -> Iterator[Diagnostic]:
    """Yield why what is to be sent does not fit the controller.

    Args:
        texts: As they are typed.
        module: What was compiled of them, or of the file they come from.
        profile: Of the controller.
    """
    yield from _characters(texts)
    yield from _long_lines(texts.programs, profile)
    yield from _long_names(module, profile)
    yield from _words(texts.programs, profile)
    used = memory_bytes(texts, module)
    if profile.memory_bytes is not None and used > profile.memory_bytes:
        yield error(
            MEMORY_FULL,
            f"programs and data need about {used:,} bytes, the controller has "
            f"{profile.memory_bytes:,}",
            notes=("an estimate: the text of the programs, and what each value takes",),
            help=("shorten comments, or take out data that no program uses",),
            data={"bytes": used, "limit": profile.memory_bytes},
        )


def memory_bytes(texts: Printed, module: Module) -> int:
    """Return what programs and data take in the controller, about. More than it is, rather."""
    text = sum(len(program) for program in texts.programs.values())
    return text + sum(ENTRY_BYTES + _size(datum.value) for datum in placed_data(module))


def truncated(found: tuple[Diagnostic, ...]) -> Iterator[Diagnostic]:
    """Yield a refusal for every name of which the compiler says that only a part counts."""
    for diagnostic in found:
        if diagnostic.rule == NAME_TRUNCATED:
            yield error(NAME_TOO_LONG, diagnostic.headline, diagnostic.primary, help=_SHORTER)


_SHORTER = ("choose a shorter name",)


def _characters(texts: Printed) -> Iterator[Diagnostic]:
    for name, text in texts.programs.items():
        lines = text.split("\n")[:-1]
        headers = [line for line in lines if line.startswith(".")]
        named = lines[0].split("(")[0].split()[:2] == [".PROGRAM", name]
        if not named or len(headers) != 2 or not lines[-1].startswith(".END"):
            yield error(
                NOT_TYPABLE,
                f"the program `{name}` does not stand between plain lines .PROGRAM and .END",
                help=(f"write `.PROGRAM {name}()` with nothing behind it, and `.END`",),
            )
        foreign = [(n, line) for n, line in enumerate(lines) if not _plain(line)]
        if foreign:
            number, line = foreign[0]
            sign = next(c for c in line if not " " <= c <= "~")
            yield error(
                NOT_TYPABLE,
                f"`{sign}` in step {number} of `{name}` is no character of the controller",
                notes=_more(len(foreign) - 1),
                help=("write comments and strings in plain ASCII letters",),
            )
    for text in (texts.strings, texts.locations, texts.reals):
        for row in text.split("\n"):
            if not _plain(row) or row.count('"') > 2:
                yield error(
                    NOT_TYPABLE,
                    f"the value of `{row.split(' ')[0]}` cannot be typed at the controller",
                    help=("let a program make it with $CHR",),
                )


def _long_lines(programs: Mapping[str, str], profile: Profile) -> Iterator[Diagnostic]:
    for name, text in programs.items():
        lengths = [len(typed(line)) for line in text.split("\n")]
        long = [n for n, length in enumerate(lengths) if length > profile.line_length]
        if long:
            steps = ", ".join(str(n) for n in long[:FEW])
            yield error(
                LINE_TOO_LONG,
                f"step {steps} of `{name}` is longer than {profile.line_length} characters",
                notes=_more(len(long) - FEW),
                help=("shorten its comment, or make two steps of it",),
                data={"longest": max(lengths), "limit": profile.line_length},
            )


def _long_names(module: Module, profile: Profile) -> Iterator[Diagnostic]:
    names = set(module.programs) | {datum.name for datum in module.data}
    for program in module.programs.values():
        names |= {slot.name for slot in (*program.formals, *program.autos)}
        names |= {name for i in program.instructions for name in global_names(i)}
    for name in sorted(names):
        if len(name.lstrip("$#")) > profile.name_length:
            yield error(
                NAME_TOO_LONG,
                f"the name `{name}` has more than {profile.name_length} characters",
                help=_SHORTER,
            )


def global_names(node: object) -> Iterator[str]:
    """Yield the name of every variable of the controller that a part of the IR speaks of."""
    if isinstance(node, Global):
        yield node.name
    elif isinstance(node, tuple):
        for part in node:  # pyright: ignore[reportUnknownVariableType]
            yield from global_names(part)  # pyright: ignore[reportUnknownArgumentType]


def _words(programs: Mapping[str, str], profile: Profile) -> Iterator[Diagnostic]:
    """Yield the words of the language that this controller has not: keywords are upper case."""
    lacks = frozenset(profile.lacks)
    for name, text in programs.items():
        for number, line in enumerate(text.split("\n")):
            for word in sorted(lacks.intersection(_WORD.findall(_QUIET.sub("", line)))):
                yield word_missing(word, number, name, profile)


def word_missing(word: str, step: int, program: str, profile: Profile) -> Diagnostic:
    """Return what to say of a word that the controller has not."""
    return error(
        WORD_MISSING,
        f"{word} in step {step} of `{program}` is no word of this controller",
        notes=(f"profile `{profile.name}`",),
        help=("write it with other words, or correct the profile if the controller has it",),
    )


def _plain(line: str) -> bool:
    return all(" " <= character <= "~" for character in line)


def _more(count: int) -> tuple[str, ...]:
    return (f"and {count} more",) if count > 0 else ()


def _size(value: Value) -> int:
    if isinstance(value, str):
        return STRING_BYTES
    if isinstance(value, float):
        return REAL_BYTES
    return POSE_BYTES if isinstance(value, Pose) else JOINTS_BYTES
