"""The list of rooms in vrts/README.md, made of what the folders say of themselves.

`python -m tests.rooms` writes it anew.
"""

import ast
import re
from pathlib import Path

from tests.places import ROOT

PACKAGE = ROOT / "vrts"
README = PACKAGE / "README.md"
BEGIN, END = "<!-- rooms -->\n", "<!-- end of rooms -->\n"
NO_ROOMS = {"stubs", "vendor", "__pycache__"}


def folders(inside: Path = PACKAGE) -> list[Path]:
    """Return every folder of code below one, in the order of their names."""
    found: list[Path] = []
    for folder in sorted(path.parent for path in inside.glob("*/__init__.py")):
        if folder.name not in NO_ROOMS:
            found += [folder, *folders(folder)]
    return found


def says(folder: Path) -> str:
    """Return the first line of what a folder says of itself."""
    said = ast.get_docstring(ast.parse((folder / "__init__.py").read_text("utf-8"))) or ""
    return said.partition("\n")[0]


def table() -> str:
    """Return the rooms of every folder as a table."""
    rows = [
        f"| `{folder.relative_to(PACKAGE)}/` | {says(folder)} |\n"
        for folder in folders()
        if folder.parent != PACKAGE
    ]
    return "| room | what it is for |\n|---|---|\n" + "".join(rows)


def written(text: str) -> str:
    """Return the text of the README with the table as it has to be."""
    pattern = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.S)
    return pattern.sub(lambda _: BEGIN + "\n" + table() + "\n" + END, text)


if __name__ == "__main__":
    README.write_text(written(README.read_text("utf-8")), "utf-8")
