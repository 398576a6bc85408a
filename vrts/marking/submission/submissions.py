"""The programs that an example comes with."""

from pathlib import Path

SOLUTION = "solution.v2"
FOLDER = "submissions"


def of_example(folder: Path) -> list[Path]:
    """Return the solution of an example and every submission in it."""
    paths = [folder / SOLUTION] if (folder / SOLUTION).is_file() else []
    inside = folder / FOLDER
    if inside.is_dir():
        paths += sorted(path for path in inside.iterdir() if not path.name.startswith("."))
    return paths
