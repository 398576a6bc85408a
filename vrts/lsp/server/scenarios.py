"""Scenarios in which a program goes wrong, as files that an editor can open."""

import hashlib
import os
from pathlib import Path
from tempfile import TemporaryDirectory

from lsprotocol import types
from pygls.uris import from_fs_path

from vrts.lsp.channel.findings import Finding

MOST_TRIED = 100  # names for a file beside a program


class Scenarios:
    """A folder of scenarios that lasts as long as the server does."""

    def __init__(self) -> None:
        """Make nothing yet: few programs need it."""
        self._folder: TemporaryDirectory[str] | None = None

    def link(self, finding: Finding) -> types.DiagnosticRelatedInformation | None:
        """Return where a client opens the scenario of a finding; None: it has none."""
        if not finding.scenario:
            return None
        file = self._written(finding)
        name = os.path.basename(finding.path)
        text = f"the scenario of it: see it with `vrts verify {name} --scenario {file}`"
        start = types.Position(0, 0)
        return types.DiagnosticRelatedInformation(
            types.Location(_address(file), types.Range(start, start)), text
        )

    def stop(self) -> None:
        """Take the files away."""
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None

    def _written(self, finding: Finding) -> Path:
        if self._folder is None:
            self._folder = TemporaryDirectory(prefix="vrts-scenarios-", ignore_cleanup_errors=True)
        same = hashlib.sha256(f"{finding.path}\n{finding.scenario}".encode()).hexdigest()[:8]
        file = Path(self._folder.name) / f"{Path(finding.path).stem}-{same}.toml"
        if not file.exists():
            file.write_text(finding.scenario, "utf-8")
        return file


def keeping(finding: Finding) -> types.WorkspaceEdit:
    """Return the edit that keeps the scenario of a finding beside its program, in a new file."""
    program = Path(finding.path)
    names = ("", *(f"-{n}" for n in range(2, MOST_TRIED)))
    files = [program.with_name(f"{program.stem}-scenario{n}.toml") for n in names]
    address = _address(next((file for file in files if not file.exists()), files[-1]))
    start = types.Position(0, 0)
    written = types.TextEdit(types.Range(start, start), finding.scenario)
    return types.WorkspaceEdit(
        document_changes=[
            types.CreateFile(address),
            types.TextDocumentEdit(
                types.OptionalVersionedTextDocumentIdentifier(address, None), [written]
            ),
        ]
    )


def _address(file: Path) -> str:
    return from_fs_path(str(file)) or str(file)
