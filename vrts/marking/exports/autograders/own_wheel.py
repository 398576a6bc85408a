"""A wheel of the vrts that runs here, made of its own files: no index is asked for it.

The name `vrts` is free on package indexes for anybody to take. So what an autograder installs is
what its maker has.
"""

import base64
import hashlib
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

from vrts import __version__
from vrts.base.diagnostic import Rule, error
from vrts.base.zips import packed
from vrts.marking.exports.autograders.own_files import (
    NoFiles,
    checkout_files,
    installed_files,
    is_checkout,
)
from vrts.pipeline.files import CHECKOUT, PACKAGE
from vrts.pipeline.refused import Refused

NO_WHEEL = Rule("V755", "no-wheel-of-vrts")

NAME = f"vrts-{__version__}-py3-none-any.whl"
MODE = 0o644  # of members
_INFO = f"vrts-{__version__}.dist-info"
_WHEEL = b"Wheel-Version: 1.0\nGenerator: vrts\nRoot-Is-Purelib: true\nTag: py3-none-any\n"


def own_wheel() -> bytes:
    """Return the wheel. The same files give the same bytes.

    Raises:
        Refused: vrts is not installed here, or what is installed does not say what it is.
    """
    try:
        installed = distribution("vrts")
    except PackageNotFoundError as missing:
        raise _refused("vrts is not installed here, it only runs from a folder") from missing
    if installed.version != __version__:
        versions = f"vrts {__version__} runs here, and {installed.version} was installed"
        raise _refused(versions)
    try:
        members = _files(installed)
    except NoFiles as problem:
        raise _refused(str(problem)) from problem
    members |= {
        f"{_INFO}/METADATA": _text(installed, "METADATA"),
        f"{_INFO}/entry_points.txt": _text(installed, "entry_points.txt"),
        f"{_INFO}/WHEEL": _WHEEL,
    }
    members[f"{_INFO}/RECORD"] = _record(members)
    return packed(members, MODE)


def _files(installed: Distribution) -> dict[str, bytes]:
    """Return the files of the vrts that runs, if it is the one that is installed."""
    place = Path(str(installed.locate_file("vrts/__init__.py")))
    if place.is_file() and place.samefile(PACKAGE / "__init__.py"):
        return installed_files(installed)
    if is_checkout(installed, CHECKOUT):
        return checkout_files(CHECKOUT)
    raise NoFiles(f"vrts runs from `{CHECKOUT}`, and another one is installed")


def _text(installed: Distribution, name: str) -> bytes:
    text = installed.read_text(name)
    if not text:
        raise _refused(f"the installed vrts has no `{name}`")
    return text.encode()


def _record(members: dict[str, bytes]) -> bytes:
    lines = [f"{name},sha256={_digest(data)},{len(data)}" for name, data in members.items()]
    return "\n".join((*lines, f"{_INFO}/RECORD,,", "")).encode()


def _digest(data: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def _refused(why: str) -> Refused:
    headline = f"no wheel of vrts can be made: {why}"
    remedies = ("build one with `python -m build --wheel`, and name it: `--wheels dist`",)
    return Refused((error(NO_WHEEL, headline, help=remedies),))
