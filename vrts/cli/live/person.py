"""What `vrts serve` does about one person from the command line, and ends."""

import os
from pathlib import Path

from vrts.cli.shared.console import WRONG, fail, say, warn


def export_user(folder: Path, name: str, output: Path | None) -> None:
    """Write all that is kept of a person as a zip."""
    from vrts.base.safe_names import safe
    from vrts.live.personal.export import export

    _require(folder)
    path = output or Path(f"{safe(name)}.zip")
    part = path.with_name(f"{path.name}.part")
    try:
        with open(os.open(part, os.O_CREAT | os.O_TRUNC | os.O_WRONLY, 0o600), "wb") as file:
            found = export(folder, name, file)
        if not found.accounts:
            fail(f"nothing is kept of `{name}`", status=WRONG)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
    say(f"{found.records} records, {found.programs} programs and {found.files} files in {path}")


def purge_user(folder: Path, name: str, key: Path | None, *, mentions: bool) -> None:
    """Forget a person, and say what is left."""
    from vrts.live.administration import purge_user as purge

    _require(folder)
    found = purge(folder, name, key, mentions=mentions)
    if not found.accounts:
        fail(f"nothing is kept of `{name}`", status=WRONG)
    say(f"accounts forgotten: {found.accounts}; the rest of the logs stays as it was")
    for copy in found.copies:
        say(f"removed an older copy of the database: {copy}")
    if found.mentions:
        warn(
            f"`{name}` still stands in {found.mentions} texts of others;"
            " `--purge-mentions` forgets these too"
        )
    if found.left:
        warn(found.left)
    warn("backups elsewhere keep what they hold: delete them, or purge again after you restore one")


def _require(folder: Path) -> None:
    if not (folder / "live.sqlite").is_file():
        fail(f"there is no server's database in `{folder}`")
