"""What a shell offers at Tab: files, scenes, codes, words of the language, students.

Nothing is loaded before somebody presses Tab.
"""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

Names = Callable[[click.Context], Iterable[str]]


class Offering(click.ParamType[Any]):
    """A kind of value that a shell can complete; all else is as the command wants it."""

    def __init__(
        self, kind: "click.ParamType[Any]", name: str, names: Names, *, file: bool
    ) -> None:
        """Take the kind, what it is called in `--help`, and what is offered.

        Args:
            kind: What the command wants.
            name: Such as "scene".
            names: All there are.
            file: Whether the path of a file may stand there, too.
        """
        self.name = name
        self._kind = kind
        self._names = names
        self._file = file

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the value as the command wants it."""
        return self._kind.convert(value, param, ctx)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> "list[CompletionItem]":
        """Return what may be typed."""
        from click.shell_completion import CompletionItem

        low = incomplete.lower()
        found = [CompletionItem(n) for n in self._names(ctx) if n.lower().startswith(low)]
        return found or ([CompletionItem(incomplete, type="file")] if self._file else [])


def offering(param: click.Parameter, command: str) -> click.Parameter:
    """Let a shell complete a parameter of a command, by the names of both."""
    name = param.name or ""
    found = OFFERS.get(f"{command} {name}", OFFERS.get(name))
    if found is not None and param.type is click.STRING:
        name, names, file = found
        param.type = Offering(param.type, name, names, file=file)
    return param


def _scenes(_ctx: click.Context) -> Iterable[str]:
    from vrts.pipeline.files import scene_names

    return scene_names()


def _examples(_ctx: click.Context) -> Iterable[str]:
    from vrts.pipeline.files import example_names

    return example_names()


def _origins(ctx: click.Context) -> Iterable[str]:
    return (*_scenes(ctx), *_examples(ctx))


def _codes(_ctx: click.Context) -> Iterable[str]:
    from importlib.resources import files

    pages = (files("vrts") / "pages").iterdir()
    return sorted(p.name.removesuffix(".md") for p in pages if p.name.endswith(".md"))


def _words(_ctx: click.Context) -> Iterable[str]:
    from vrts.ask.words import facts

    return sorted(facts())


def _students(ctx: click.Context) -> Iterable[str]:
    folder = ctx.params.get("folder")
    home = Path(folder) / "students" if folder else None
    return sorted(p.name for p in home.iterdir()) if home is not None and home.is_dir() else ()


def _nothing(_ctx: click.Context) -> Iterable[str]:
    return ()


OFFERS: dict[str, tuple[str, Names, bool]] = {  # name of a parameter: as help calls it, what, file
    "show name": ("scene", _scenes, True),
    "check name": ("scene", _scenes, True),
    "watch name": ("scene", _scenes, True),
    "scene": ("scene", _scenes, True),
    "scenes": ("scene", _scenes, True),
    "origin": ("scene", _origins, True),
    "codes": ("code", _codes, False),
    "word": ("word", _words, False),
    "student": ("student", _students, False),
    "task": ("task", _examples, True),
    "others": ("file", _nothing, True),
    "files": ("file", _nothing, True),
    "table": ("file", _nothing, True),
    "place": ("file", _nothing, True),
}
