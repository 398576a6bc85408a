"""What `fmt` and `fix` say of files that they change."""

from pathlib import Path

from vrts.cli.shared.console import out


def file_shown(path: Path, name: str) -> str:
    """Return the name of a file, and of the one that it is a link to."""
    return f"{name}, a link to {path.resolve()}" if path.is_symlink() else name


def print_diff(before: str, after: str, name: str) -> None:
    """Print what changes in a text."""
    from difflib import unified_diff

    from vrts.report.plain import plain_text

    rows = unified_diff(before.splitlines(), after.splitlines(), name, name, lineterm="")
    for row in rows:
        out(plain_text(row))
