"""Profiles by name, as they come with vrts, or from a TOML file of the user's."""

import re
from pathlib import Path

from vrts.dispatch.profile_file import read_profile
from vrts.dispatch.profile_parts import NOT_TRIED, Profile
from vrts.pipeline.files import CannotRead, read_toml_source

__all__ = ["NOT_TRIED", "Profile", "find_profile", "profile_names", "profile_text"]

_FOLDER = Path(__file__).parent / "profiles"


def profile_names() -> tuple[str, ...]:
    """Return the names of the profiles that come with vrts."""
    return tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))


def find_profile(name: str) -> Profile:
    """Return a profile: by its name, or from a file whose name ends in `.toml`.

    Raises:
        CannotRead: There is none.
        Refused: Its file has errors.
    """
    if name.endswith(".toml"):
        return read_profile(read_toml_source(Path(name)))
    return read_profile(read_toml_source(_path(name)))


def profile_text(name: str) -> str:
    """Return the file of a profile that comes with vrts.

    Raises:
        CannotRead: There is none of this name.
    """
    return read_toml_source(_path(name)).text


def _path(name: str) -> Path:
    path = _FOLDER / f"{name}.toml"
    if not re.fullmatch(r"[a-z0-9-]{1,40}", name) or not path.is_file():
        hints = (f"profiles: {', '.join(profile_names())}; or a file of yours, NAME.toml",)
        raise CannotRead(f"there is no profile `{name}`", hints)
    return path
