"""Two processes with different hash seeds write the same bytes."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
PROGRAM = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"


def test_results_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    outputs: list[bytes] = []
    pages: list[bytes] = []
    for seed in ("1", "2"):
        page = tmp_path / f"{seed}.html"
        result = subprocess.run(
            [
                *(sys.executable, "-m", "vrts.cli.main", "verify", PROGRAM),
                *("--format", "json", "--html", page),
            ],
            capture_output=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=False,
        )
        outputs.append(result.stdout)
        pages.append(page.read_bytes())
    assert outputs[0] == outputs[1]
    assert pages[0] == pages[1]
