"""The type checker for the browser's modules reads their JSDoc, three's part included."""

import os
import subprocess
from pathlib import Path

import pytest

from tests.__main__ import STAGES, WEB

DENO, *CHECK = STAGES["browser-types"][:7]


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("figure(1.5, 2);", ""),
        ('figure("one", 2);', "TS2345"),
        pytest.param("new Vector3().fromArrays([1, 2, 3]);", "TS2551", marks=pytest.mark.thorough),
    ],
)
def test_a_wrong_argument_is_found(tmp_path: Path, line: str, code: str) -> None:
    module = tmp_path / "probe.js"
    module.write_text(
        f'import {{ figure }} from "{(WEB / "live" / "dom.js").as_uri()}";\n'
        f'import {{ Vector3 }} from "three";\nnew Vector3();\nfigure(1, 1);\n{line}\n'
    )
    environment = dict(os.environ, DENO_NO_UPDATE_CHECK="1", NO_COLOR="1")
    found = subprocess.run(
        [DENO, *CHECK, str(module)], capture_output=True, text=True, check=False, env=environment
    )
    assert (found.returncode == 0) == (code == ""), found.stderr
    assert code in found.stdout + found.stderr
