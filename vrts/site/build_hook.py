"""What hatchling calls for a wheel or an editable install: it adds the manual.

A wheel holds the site and the man pages. For an editable install the site is written into the
folder itself, where Git ignores it.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.config import BuilderConfig
from hatchling.builders.hooks.plugin.interface import BuildHookInterface

SITE = "vrts/site/built"
MAN = "share/man/man1"
EDITABLE = "editable"


class ManualBuildHook(BuildHookInterface[BuilderConfig]):
    """Builds the manual in a process of its own and puts it where the wheel takes it from."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the site and the man pages before the wheel is written."""
        if version == EDITABLE:
            self._run()
            build_data["shared_data"][f"{SITE}/man"] = MAN
            return
        self._work = tempfile.TemporaryDirectory(prefix="vrts-manual-")
        html, man = Path(self._work.name) / "html", Path(self._work.name) / "man"
        self._run(str(html), str(man))
        build_data["force_include"][str(html)] = SITE
        build_data["shared_data"][str(man)] = MAN

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Take away what the wheel was made of."""
        if version != EDITABLE:
            self._work.cleanup()

    def _run(self, *folders: str) -> None:
        """Build in a process of its own, which finds vrts in this folder."""
        paths = [self.root, os.environ.get("PYTHONPATH", "")]
        environment = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join(filter(None, paths)),
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        command = [sys.executable, "-m", "vrts.site", *folders]
        done = subprocess.run(  # noqa: S603 -- this Python, this folder
            command, env=environment, cwd=self.root, capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise RuntimeError(f"the manual could not be built:\n{done.stdout}{done.stderr}")
        for line in done.stderr.splitlines():
            self.app.display_warning(line)
