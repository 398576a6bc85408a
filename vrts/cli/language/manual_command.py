"""`vrts manual`."""

import shutil
import sys
import webbrowser
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grammar.group import LazyGroup
from vrts.cli.shared.console import WRONG, fail, guarded, out, use_color, warn
from vrts.cli.shared.options import color_option, form_option

if TYPE_CHECKING:
    from vrts.ask.manual import Answer, Manual
    from vrts.ask.page import Page
    from vrts.ask.terminal import Look

SITE = Path(str(files("vrts"))) / "site" / "built"
NOT_BUILT = (
    "the manual's pages were not built when vrts was installed",
    (
        "type `python -m pip install -e .` in the folder with pyproject.toml: it builds them",
        "or read a page here: `vrts manual MOVES`",
    ),
)
EPILOG = """\b
Examples:
  vrts manual
  vrts manual MOVES
  vrts manual wait 2 seconds
  vrts manual "what does V301 mean?"
  vrts manual --list
"""
MOST_PRINTED = 10  # pages, as JSON
TITLES = {"do": "Do", "look up": "Look up", "understand": "Understand"}


@click.command(name="manual", epilog=EPILOG)
@click.argument("what", nargs=-1)
@click.option("--path", is_flag=True, help="Only print where the manual is; open nothing.")
@click.option("--list", "listed", is_flag=True, help="List the pages, and what to type for each.")
@form_option("full", "json")
@color_option
@click.pass_context
@guarded
def command(
    ctx: click.Context, what: tuple[str, ...], path: bool, listed: bool, form: str, color: str
) -> None:
    """Show the page about WHAT: a word, a message, a command, or any question in your own words.

    Without WHAT the manual opens in the browser. It is on this machine: no network is needed.
    """
    question = " ".join(what).strip()
    root = ctx.find_root()
    if listed:
        _list(root)
    elif question and form == "json":
        _print(root, question)
    elif question:
        _show(root, question, color)
    elif what or form == "json":
        fail("nothing is asked", ("write what you look for: `vrts manual wait 2 seconds`",))
    else:
        _open(path)


def _open(path: bool) -> None:
    first = first_page()
    if first is None:
        fail(*NOT_BUILT, status=WRONG)
    out(str(first))
    if not path and not webbrowser.open(first.as_uri()):
        warn("no browser could be opened: open this file in one")


def first_page() -> Path | None:
    """Return the manual's first page; None where it was not built."""
    first = SITE / "index.html"
    return first if first.is_file() else None


def manual(root: click.Context) -> "Manual":
    """Return the manual with the commands of this command line."""
    from vrts.ask.manual import Manual

    assert isinstance(root.command, LazyGroup)
    sections = root.command.sections
    return Manual({name: says for named in sections.values() for name, says in named.items()})


def _print(root: click.Context, question: str) -> None:
    from vrts.report.formats.json_text import json_text

    pages = [hit.page for hit in manual(root).search(question).hits[:MOST_PRINTED]]
    rows = [{"name": p.name, "kind": p.kind.value, "title": p.title} for p in pages]
    out(json_text({"schema": "vrts.manual/1", "pages": rows}))


def _show(root: click.Context, question: str, color: str) -> None:
    from vrts.ask.terminal import WIDEST, Look

    known = manual(root)
    answer = known.answer(question)
    if answer.page is None:
        hints = tuple(f"did you mean `vrts manual {_typed(name)}`?" for name in answer.near[:1])
        hints += ("ask in other words, or see `vrts manual --list`",)
        fail(f"the manual has no page about `{question[:80]}`", hints)
    columns = shutil.get_terminal_size().columns if sys.stdout.isatty() else WIDEST
    look = Look(max(40, min(columns, WIDEST)), use_color(color))
    out("\n".join(_lines(root, known, answer, look)))


def _lines(root: click.Context, known: "Manual", answer: "Answer", look: "Look") -> list[str]:
    page = answer.page
    assert page is not None
    rows = [f"(`{said}` was read as `{near}`)" for said, near in answer.read_as.items()]
    rows += [""] if rows else []
    rows += _body(root, known, page, look)
    if page.section:
        rows += ["", f"the whole page: vrts manual {page.of}"]
    listed = _with_kin(known, page, answer.others)
    if listed:
        typed = [f"vrts manual {_typed(other.name)}" for other in listed]
        width = min(max(map(len, typed)), 46)
        rows += ["", "see also"]
        rows += [
            f"  {words:<{width}}  {_title(other)}"
            for words, other in zip(typed, listed, strict=True)
        ]
    return rows


def _with_kin(known: "Manual", page: "Page", others: "tuple[Page, ...]") -> "tuple[Page, ...]":
    """Return what is listed below a page: of a word, first the recipes that use it."""
    from vrts.ask.manual import MOST_ELSE
    from vrts.ask.page import Kind

    kin = known.recipes_with(page.name)[:2] if page.kind is Kind.WORD else ()
    rules = known.sections_about(page.name)[1:3] if page.kind is Kind.WORD else ()
    every = dict.fromkeys((*kin, *rules, *others))
    return tuple(every)[: MOST_ELSE + 1]


def _body(root: click.Context, known: "Manual", page: "Page", look: "Look") -> list[str]:
    from vrts.ask.manual import text_of
    from vrts.ask.page import Kind

    match page.kind:
        case Kind.WORD:
            rules = known.sections_about(page.name)[:1]
            return "\n\n".join(text_of(each, look) for each in (page, *rules)).splitlines()
        case Kind.COMMAND:
            return _help(root, page.name.removeprefix("vrts ")).splitlines()
        case _:
            return text_of(page, look).splitlines()


def _help(root: click.Context, name: str) -> str:
    assert isinstance(root.command, click.Group)
    found = root.command.get_command(root, name)
    assert found is not None, name
    return found.get_help(click.Context(found, info_name=name, parent=root))


def _list(root: click.Context) -> None:
    from vrts.ask.page import Kind

    pages = [page for page in manual(root).pages if not page.section]
    for kind in (Kind.RECIPE, Kind.RULE, Kind.BACKGROUND):
        names = [page for page in pages if page.kind is kind]
        width = max((len(page.name) for page in names), default=0)
        out(f"{TITLES[kind.value]}")
        for page in names:
            out(f"  {page.name:<{width}}  {page.title}")
        out("")
    out("and every word of the language (`vrts support`), message (`vrts explain`)")
    out("and command (`vrts --help`): type `vrts manual` and its name")


def _typed(name: str) -> str:
    return f"'{name}'" if name[0] in "$#" else name


def _title(page: "Page") -> str:
    from vrts.ask.page import Kind

    return page.text.partition("\n")[0] if page.kind in (Kind.WORD, Kind.COMMAND) else page.title
