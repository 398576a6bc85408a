"""The wheel of vrts, installed in an environment and a folder of its own, outside the checkout.

Dependencies come from the environment of the tests, by a path; vrts itself does not. A wheel that
is built already is taken where the variable VRTS_WHEEL names it.
"""

import os
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from tests.places import ROOT

_kept: list["TemporaryDirectory[str]"] = []  # until the tests end


class Installed(NamedTuple):
    """An environment with vrts in it."""

    home: Path

    @property
    def vrts(self) -> Path:
        """The command."""
        return self.home / "bin" / "vrts"

    def run(
        self, words: Sequence[str], cwd: Path, timeout: float = 300.0
    ) -> "subprocess.CompletedProcess[str]":
        """Type a command."""
        return subprocess.run(
            [self.vrts, *words],
            cwd=cwd,
            env=alone(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
        )


def alone() -> Mapping[str, str]:
    """Return an environment in which nothing points at the checkout, and no browser is opened."""
    plain = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return {**plain, "BROWSER": "true", "NO_COLOR": "1"}


def build_wheel(folder: Path) -> Path:
    """Build the wheel and return its file."""
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder)]
    subprocess.run([*command, str(ROOT)], check=True, capture_output=True)
    return next(folder.glob("vrts-*.whl"))


@cache
def installed() -> Installed:
    """Return an environment with the wheel, made once."""
    folder = TemporaryDirectory(prefix="vrts-wheel-")
    _kept.append(folder)
    place = Path(folder.name)
    built = os.environ.get("VRTS_WHEEL")
    wheel = build_wheel(place) if built is None else Path(built)
    home = place / "env"
    venv.create(home, with_pip=False)
    pip = [sys.executable, "-m", "pip", "--python", str(home / "bin" / "python"), "install"]
    offline = ["-q", "--no-deps", "--no-index", "--disable-pip-version-check", str(wheel)]
    subprocess.run([*pip, *offline], check=True, capture_output=True)
    site = home / "lib" / f"python3.{sys.version_info.minor}" / "site-packages"
    added = f"import site; site.addsitedir({sysconfig.get_path('purelib')!r})\n"
    (site / "dependencies.pth").write_text(added)
    return Installed(home)
