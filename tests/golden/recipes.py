"""Write the outputs shown in the manual's recipes anew: `python -m tests.golden.recipes`.

Each begins in an empty folder.
"""

from pathlib import Path
from tempfile import TemporaryDirectory

from tests.golden.tutorial import Shown, follow, rewritten
from tests.places import ROOT

FOLDER = ROOT / "vrts" / "manual" / "do"


def recipes() -> list[str]:
    """Return the names of all recipes."""
    return sorted(path.stem for path in FOLDER.glob("*.md") if path.stem != "index")


def text_of(recipe: str) -> str:
    """Return the page of a recipe."""
    return (FOLDER / f"{recipe}.md").read_text(encoding="utf-8")


def followed(recipe: str) -> list[Shown]:
    """Return the commands of a recipe with what they show and what came of them."""
    with TemporaryDirectory() as temporary:
        folder = Path(temporary) / "empty"
        folder.mkdir()
        return list(follow(text_of(recipe), folder))


def main() -> None:
    """Write the files."""
    for recipe in recipes():
        with TemporaryDirectory() as temporary:
            folder = Path(temporary) / "empty"
            folder.mkdir()
            text = rewritten(text_of(recipe), folder)
        if text != text_of(recipe):
            (FOLDER / f"{recipe}.md").write_text(text, encoding="utf-8")
            print(recipe)


if __name__ == "__main__":
    main()
