"""Programs, and where they run, as callers of the public API name them."""

import os
from collections.abc import Iterable
from numbers import Real
from pathlib import Path
from typing import NamedTuple, TypeAlias, cast

from vrts.api.errors import wrong_call
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import read_bytes, shown

File: TypeAlias = str | os.PathLike[str]
"""A path."""

Program: TypeAlias = str | os.PathLike[str]
"""A path of a program; or the text of one, which has more than one line."""

TEXT = "program.v2"  # what a program is called that comes as text
AUTO = "auto"


class Given(NamedTuple):
    """A program, with the place that its task is looked for beside."""

    program: ProgramFile
    path: Path | None  # None: it came as text, or from stdin

    @property
    def folder(self) -> Path | None:
        """Where files that belong to it are looked for first."""
        return None if self.path is None else self.path.parent


def given(program: Program) -> Given:
    """Return a program by its path, or as text.

    Raises:
        CannotRead: There is no such file.
        VrtsError: It is neither a path nor text.
    """
    if isinstance(program, str) and "\n" in program:
        return Given(ProgramFile(program.encode("utf-8", "replace"), TEXT), None)
    path = path_of(program)
    return Given(ProgramFile(read_bytes(path), shown(path)), path)


def path_of(file: object) -> Path:
    """Return a path.

    Raises:
        VrtsError: It is none.
    """
    if not isinstance(file, str | os.PathLike):
        raise wrong_call(f"a path is wanted, not {type(file).__name__}")
    name = cast("str | bytes", os.fspath(cast("os.PathLike[str]", file)))
    if not isinstance(name, str) or "\0" in name:
        raise wrong_call("a path is text without null characters")
    try:
        os.fsencode(name)
    except UnicodeEncodeError as problem:  # half of a character
        raise wrong_call("a path is text that files can be called by") from problem
    return Path(name)


def word(text: object, what: str) -> str | None:
    """Return a name that may be left out.

    Raises:
        VrtsError: It is no text.
    """
    if text is None or isinstance(text, str):
        return text
    raise wrong_call(f"`{what}` is text, not {type(text).__name__}")


def number(value: object, what: str) -> float:
    """Return a number.

    Raises:
        VrtsError: It is none.
    """
    if isinstance(value, Real):
        return float(value)
    raise wrong_call(f"`{what}` is a number, not {type(value).__name__}")


def optional_path(file: File | None) -> Path | None:
    """Return a path, if there is one."""
    return None if file is None else path_of(file)


def reading(dialect: str | None, files: Iterable[File] | File, default: str) -> Reading:
    """Return how programs are read.

    Args:
        dialect: `val2`, `val2+`, `val`, `vplus` or `as`; `auto`: as file name and content tell;
            None: `default`.
        files: Compiled together with the program.
        default: One of these.

    Raises:
        CannotRead: A file is not there.
        VrtsError: There is no such dialect.
    """
    named = word(dialect, "dialect") or default
    if named != AUTO and named not in DIALECTS:
        raise wrong_call(
            f"there is no dialect `{named}`", f"dialects: {', '.join((AUTO, *DIALECTS))}"
        )
    several = (files,) if isinstance(files, str | os.PathLike) else tuple(files)
    others = tuple(given(file).program for file in several)
    return Reading(None if named == AUTO else named, others=others)
