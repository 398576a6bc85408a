"""A program that was compiled."""

from vrts.api.errors import public, refusal, text_of
from vrts.api.given import File, given, reading
from vrts.api.given import Program as Source
from vrts.ir.dump import dump
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import Compiled, compile_bytes
from vrts.pipeline.compiling.storing import store


class Program:
    """A program as far as it compiles. Made by `vrts.compile`."""

    def __init__(self, compiled: Compiled) -> None:
        """Take what was compiled."""
        self._compiled = compiled

    @property
    def ok(self) -> bool:
        """Whether it compiles."""
        return self._module is not None

    @property
    def problems(self) -> tuple[str, ...]:
        """What the compiler has to say, each as the commands show it."""
        return tuple(text_of(one) for one in self._compiled.diagnostics)

    @property
    def codes(self) -> tuple[str, ...]:
        """The codes of the problems: `vrts explain CODE` tells more."""
        return tuple(one.rule.code for one in self._compiled.diagnostics)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the programs in it; none where it does not compile."""
        return () if self._module is None else tuple(self._module.programs)

    @property
    def dialect(self) -> str | None:
        """Language that it is read as; None for what is no text."""
        compilation = self._compiled.compilation
        return None if compilation is None else compilation.dialect.name

    @public
    def ir(self) -> str:
        """Return the program as typed instructions, for people.

        Raises:
            VrtsError: It does not compile.
        """
        return dump(self._sound())

    @public
    def store(self, *, exact: bool = False) -> str:
        """Return what the controller's STORE writes.

        Args:
            exact: Whether to write locations with all their digits.

        Raises:
            VrtsError: It does not compile.
        """
        self._sound()
        assert self._compiled.compilation is not None
        return store(self._compiled.compilation, exact=exact)

    @property
    def _module(self) -> Module | None:
        compilation = self._compiled.compilation
        return None if compilation is None else compilation.module

    def _sound(self) -> Module:
        if self._module is None:
            raise refusal(self._compiled.diagnostics)
        return self._module

    def __repr__(self) -> str:
        """Return the program in a line."""
        what = ", ".join(self.names) if self.ok else f"does not compile: {', '.join(self.codes)}"
        return f"<vrts.Program {what}>"

    def __str__(self) -> str:
        """Return what the compiler has to say, else the names of the programs."""
        return "\n\n".join(self.problems) or f"compiles: {', '.join(self.names)}"


@public
def compile(  # noqa: A001 -- `vrts.compile`, as the command
    program: Source, *, dialect: str | None = None, files: tuple[File, ...] = ()
) -> Program:
    r"""Check a program for mistakes, without running it.

    A program with mistakes is an answer, not an error: ask it for `ok` and `problems`.

    Args:
        program: A path, or the text of a program, which has several lines.
        dialect: `val2`, `val2+`, `val`, `vplus` or `as`; None: as name and content tell.
        files: Compiled together with the program.

    Raises:
        VrtsError: A file is not there, or there is no such dialect.

    >>> import vrts
    >>> vrts.compile(".PROGRAM go()\nMOVE home\nSPED 30\n.END\n").codes
    ('V120',)
    >>> vrts.compile(".PROGRAM go()\nDRIVE 1, 30, 100\n.END\n").names
    ('go',)
    """
    return Program(compile_bytes(*given(program).program, reading(dialect, files, "auto")))
