"""Rules of the house that no linter knows."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.places import ROOT

PACKAGE = ROOT / "vrts"
MODULES = sorted(p for p in PACKAGE.rglob("*.py") if "stubs" not in p.parts)

HEAVY = ("numpy", "pinocchio", "coal", "fcl", "trimesh", "rerun", "hypothesis")


def test_every_citation_key_is_defined() -> None:
    defined = set(re.findall(r"^\| \[(\w+)\] \|", (PACKAGE / "README.md").read_text(), re.M))
    used = {
        (key, path.name)
        for path in MODULES
        for key in re.findall(r"\[([A-Z]\w*\d{4}|Rodrigues)\]_", path.read_text())
    }
    assert used, "no citation found: the pattern is wrong"
    assert {(key, where) for key, where in used if key not in defined} == set()


def test_light_packages_load_no_heavy_library() -> None:
    modules = [
        ".".join(path.relative_to(ROOT).with_suffix("").parts)
        for package in ("base", "ir", "lang")
        for path in (PACKAGE / package).rglob("*.py")
    ]
    program = f"import sys, {', '.join(modules)}; print([m for m in {HEAVY!r} if m in sys.modules])"
    result = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert result.stdout.strip() == "[]"


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(PACKAGE)))
def test_no_module_runs_user_text_or_hides_an_error(path: Path) -> None:
    tree = ast.parse(path.read_text())
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            assert node.func.id not in {"eval", "exec", "compile", "__import__"}, node.lineno
        if isinstance(node, ast.ExceptHandler):
            assert node.type is not None, f"bare except at {node.lineno}"
            only_pass = len(node.body) == 1 and isinstance(node.body[0], ast.Pass)
            names = ast.unparse(node.type)
            assert not (only_pass and "Exception" in names), f"swallowed error at {node.lineno}"


def test_the_top_level_holds_only_what_was_agreed() -> None:
    tracked = subprocess.run(
        ["git", "ls-files"], capture_output=True, text=True, check=False, cwd=ROOT
    )
    if tracked.returncode:
        pytest.skip("not a git checkout")
    tops = {line.split("/")[0] for line in tracked.stdout.splitlines()}
    agreed = {"pyproject.toml", "README.md", "LICENSE", "vrts", "examples", "scenes", "tests"}
    assert {top for top in tops if not top.startswith(".")} <= agreed
