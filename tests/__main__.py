"""Run every check of the project, one stage after another: `python -m tests`.

Stages: format, lint, types, types of the browser's modules (tsc by their JSDoc, as Deno has it),
import contracts, sabotage, tests (spec, unit, property, oracle, golden, browser). Prints the time
of each; exit status 0 when all pass. `python -m tests lint types` runs those stages only.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
BIN = Path(sys.executable).parent
PYTHON = sys.executable

WEB = ROOT / "vrts" / "web"
MODULES = sorted(str(p) for p in WEB.rglob("*.js") if WEB / "vendor" not in p.parents)

STAGES: dict[str, list[str]] = {
    "format": [str(BIN / "ruff"), "format", "--check", "--quiet", "."],
    "lint": [str(BIN / "ruff"), "check", "--quiet", "."],
    "types": [str(BIN / "basedpyright"), "--level", "error", "--pythonpath", PYTHON],
    "browser-types": [
        *(str(BIN / "deno"), "check", "--quiet", "--no-remote", "--no-npm"),
        *("--config", str(ROOT / "vrts" / "stubs" / "browser" / "deno.json"), *MODULES),
    ],
    "imports": [str(BIN / "lint-imports"), "--no-cache"],
    "sabotage": [PYTHON, "-m", "tests.sabotage"],
    "tests": [PYTHON, "-m", "pytest", "-n", "2", "--durations", "5"],
}


def main(chosen: list[str]) -> int:
    """Run the chosen stages, or all, and return the exit status."""
    unknown = set(chosen) - set(STAGES)
    if unknown:
        print(f"no such stage: {', '.join(sorted(unknown))}; stages: {', '.join(STAGES)}")
        return 2
    environment = dict(
        os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", DENO_NO_UPDATE_CHECK="1"
    )
    failed: list[str] = []
    times: list[str] = []
    for name in chosen or STAGES:
        print(f"== {name}", flush=True)
        start = time.perf_counter()
        result = subprocess.run(STAGES[name], cwd=ROOT, env=environment, check=False)
        took = time.perf_counter() - start
        times.append(f"{name} {took:.1f} s")
        if result.returncode:
            failed.append(name)
    print("== " + ", ".join(times))
    print("== failed: " + ", ".join(failed) if failed else "== everything passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
