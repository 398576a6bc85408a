"""`vrts explain`."""

from difflib import get_close_matches
from importlib.resources import files
from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, out

EPILOG = """\b
Examples:
  vrts explain
  vrts explain V301
  vrts explain joint-speed V400
  vrts explain --assumptions
"""


@click.command(name="explain", epilog=EPILOG)
@click.argument("codes", metavar="[CODE]...", nargs=-1)
@click.option(
    "--assumptions",
    is_flag=True,
    help="List what vrts had to assume: what, how much, why, and how to find out.",
)
@guarded
def command(codes: tuple[str, ...], assumptions: bool) -> None:
    """Explain diagnostics by CODE or name; without one, list them all."""
    if assumptions:
        _list_assumptions()
        return
    pages = _pages()
    if not codes:
        for key, slug in pages.items():
            out(f"{key}  {slug}")
        return
    for number, key in enumerate([_key(code, pages) for code in codes]):
        text = (files("vrts") / "pages" / f"{key}.md").read_text(encoding="utf-8")
        out(f"\n{text}" if number else text, end=False)


def _key(code: str, pages: dict[str, str]) -> str:
    """Return the code that somebody means by it, or by its name."""
    by_slug = {slug: key for key, slug in pages.items()}
    key = code.upper() if code.upper() in pages else by_slug.get(code.lower())
    if key is None:
        near = get_close_matches(code.upper(), pages, 1, 0.5) or get_close_matches(code, by_slug, 1)
        fail(
            f"there is no diagnostic `{code}`",
            (f"did you mean `{near[0]}`?",) if near else ("`vrts explain` lists all",),
        )
    return key


def _list_assumptions() -> None:
    """Print every decision, by the rules of the manual and by the marks in the source."""
    from vrts.ask.assumed import assumed_text
    from vrts.report.assumptions import decisions

    package = Path(str(files("vrts")))
    sources = {
        ".".join(path.relative_to(package).with_suffix("").parts): path.read_text(encoding="utf-8")
        for path in sorted(package.rglob("*.py"))
    }
    out(assumed_text(decisions(sources)))


def _pages() -> dict[str, str]:
    """Return the slug of every code, from the first line of its page."""
    found: dict[str, str] = {}
    for page in sorted((files("vrts") / "pages").iterdir(), key=lambda p: p.name):
        if page.name.endswith(".md"):
            title = page.read_text(encoding="utf-8").split("\n", 1)[0]
            found[page.name.removesuffix(".md")] = title.lstrip("# ").partition(" ")[2]
    return found
