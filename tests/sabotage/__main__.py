"""Apply each patch to a copy of the tree and demand that the named tests fail.

A patch that no test notices, or that no longer applies, fails this stage. Before anything is
patched the named tests must pass, so that a failure is the patch's doing. Tests are those of the
usual run, with its few examples, but for patches that say that only a `thorough` test notices.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tests.sabotage.patches import PATCHES, Patch

ROOT = Path(__file__).parent.parent.parent
COPIED = ("vrts", "tests", "examples", "scenes", "pyproject.toml", "README.md")
SECONDS = 300


def main(words: list[str]) -> int:
    """Try every patch whose name holds one of the words (all without words)."""
    chosen = [patch for patch in PATCHES if not words or any(w in patch.name for w in words)]
    with tempfile.TemporaryDirectory() as folder:
        untouched = copy_tree(ROOT, Path(folder) / "untouched")
        for thorough in {patch.thorough for patch in chosen}:
            these = [patch for patch in chosen if patch.thorough is thorough]
            targets = sorted({test for patch in these for test in patch.tests})
            if run_tests(untouched, targets, *selection(thorough), "-n", "2"):
                print("the named tests fail without any patch")
                return 1
        with ThreadPoolExecutor(max_workers=2) as pool:
            jobs = [pool.submit(verdict, patch, untouched) for patch in chosen]
            verdicts = [job.result() for job in jobs]
    for patch, problem in zip(chosen, verdicts, strict=True):
        print(f"{'noticed ' if problem is None else 'MISSED  '} {patch.name}" + (problem or ""))
    missed = [problem for problem in verdicts if problem is not None]
    print(f"sabotage: {len(chosen) - len(missed)} of {len(chosen)} patches noticed")
    return 1 if missed else 0


def verdict(patch: Patch, untouched: Path) -> str | None:
    """Return None when the tests notice the patch, else what is wrong.

    The copy is of links, and holds what Python has compiled of the untouched tree: this takes a
    quarter less time.
    """
    tree = untouched.with_name(patch.name.replace(" ", "-"))
    shutil.copytree(untouched, tree, copy_function=os.link)
    target = tree / patch.file
    text = target.read_text(encoding="utf-8")
    if text.count(patch.before) != 1:
        return f": its text stands {text.count(patch.before)} times in {patch.file}"
    target.unlink()  # a link: the untouched tree stays as it is
    target.write_text(text.replace(patch.before, patch.after), encoding="utf-8")
    try:
        noticed = run_tests(tree, patch.tests, *selection(patch.thorough))
    except subprocess.TimeoutExpired:
        return f": its tests did not end within {SECONDS} s"
    shutil.rmtree(tree)
    return None if noticed else ": no test failed"


def selection(thorough: bool) -> tuple[str, ...]:
    """Return pytest's options for the tests that are to notice."""
    return ("-m", "thorough and not live") if thorough else ()


def copy_tree(root: Path, to: Path) -> Path:
    """Copy what the tests need, without what was compiled."""
    ignore = shutil.ignore_patterns("__pycache__", "*.rrd", "bench")
    to.mkdir(parents=True)
    for name in COPIED:
        source = root / name
        if source.is_dir():
            shutil.copytree(source, to / name, ignore=ignore)
        else:
            shutil.copy2(source, to / name)
    return to


def run_tests(tree: Path, tests: "tuple[str, ...] | list[str]", *options: str) -> bool:
    """Run tests in a tree; return whether any failed. A run that collects nothing raises."""
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", PYTHONPATH=str(tree))
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:randomly", *options, *tests]
    result = subprocess.run(
        command,
        cwd=tree,
        env=environment,
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    if result.returncode not in (0, 1, 2):
        raise RuntimeError(result.stdout + result.stderr)
    return result.returncode != 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
