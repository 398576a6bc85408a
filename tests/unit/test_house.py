"""Rules of the house that no linter knows."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests import rooms
from tests.imports import circles, graph, imports, modules, siblings
from tests.places import ROOT

PACKAGE = ROOT / "vrts"
MODULES = sorted(p for p in PACKAGE.rglob("*.py") if "stubs" not in p.parts)

MOST_MODULES = 15  # of a folder, beside `__init__`
MOST_LINES = 5  # of what a folder says of itself
DOORS = {  # imports within functions below `cli`, each with its reason beside it
    # libraries that need not be installed
    ("vrts.dispatch.transfer.port", "serial"),
    ("vrts.geometry.proposing.choose", "vrts.geometry.proposing.by_coal"),
    ("vrts.marking.remote.dask_cluster", "dask_jobqueue"),
    ("vrts.marking.remote.mark_on_dask", "vrts.marking.remote.dask_cluster"),
    ("vrts.marking.submission.marker", "vrts.report.recording"),
    ("vrts.marking.submission.report_files", "vrts.report.recording"),
    ("vrts.marking.supervise.limits", "resource"),
    ("vrts.validate.camera.compare", "vrts.report.recording.through_camera"),
    ("vrts.validate.log.log_formats", "vrts.validate.log.bags.joint_states"),
    ("vrts.validate.log.log_formats", "vrts.validate.log.matlab"),
    # numpy, which most runs of programs do without: a third of the time that they take
    ("vrts.engine.hand.hand", "vrts.engine.hand.settle"),
    ("vrts.robots.urdf.serial_robot", "vrts.robots.urdf.hulls"),
}
FOLDERS = sorted({path.parent for path in MODULES} - {PACKAGE})

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
        for package in ("base", "ir", "lang", "pipeline/compiling")
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
    agreed |= {"CHANGELOG.md", "CITATION.cff"}  # where people and platforms look for them
    assert {top for top in tops if not top.startswith(".")} <= agreed


@pytest.mark.parametrize("folder", [PACKAGE, *FOLDERS], ids=lambda p: str(p.relative_to(ROOT)))
def test_no_folder_is_too_full_to_be_seen_at_a_glance(folder: Path) -> None:
    assert len([path for path in folder.glob("*.py") if path.stem != "__init__"]) <= MOST_MODULES


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda p: str(p.relative_to(PACKAGE)))
def test_a_folder_says_what_it_is_for_what_comes_in_and_what_goes_out(folder: Path) -> None:
    said = ast.get_docstring(ast.parse((folder / "__init__.py").read_text("utf-8"))) or ""
    assert len(said.splitlines()) <= MOST_LINES
    assert re.search(r"^In(:| and out:)", said, re.M), "what comes in"
    assert re.search(r"\bOut:|\bIn and out:", said), "what goes out"


def test_circles_are_found() -> None:
    edges = {"a": frozenset("b"), "b": frozenset("c"), "c": frozenset("b"), "d": frozenset("a")}
    assert circles(edges) == [["b", "c"]]


def test_no_modules_import_each_other_in_a_circle() -> None:
    assert len(graph()) > 500
    assert circles(graph()) == []


@pytest.mark.parametrize("folder", [PACKAGE, *FOLDERS], ids=lambda p: str(p.relative_to(ROOT)))
def test_within_a_folder_imports_point_one_way(folder: Path) -> None:
    name = ".".join(folder.relative_to(ROOT).parts)
    assert circles(siblings(graph(), name)) == []


def test_imports_below_the_commands_stand_at_the_top_but_for_doors() -> None:
    deferred = {
        (name, imported.target)
        for name, path in modules().items()
        if not name.startswith("vrts.cli.")
        for imported in imports(path, modules())
        if imported.deferred
    }
    assert deferred == DOORS


def test_imports_within_functions_say_why() -> None:
    for name, _ in DOORS:
        lines = modules()[name].read_text("utf-8").splitlines()
        for imported in imports(modules()[name], modules()):
            if imported.deferred:
                assert "#" in lines[imported.line - 1] + lines[imported.line - 2], name


def test_the_list_of_rooms_is_what_the_folders_say() -> None:
    text = rooms.README.read_text("utf-8")
    assert text == rooms.written(text), "`python -m tests.rooms` writes it anew"


def test_names_in_how_vrts_is_built_exist() -> None:
    text = rooms.README.read_text("utf-8")
    stems = {path.stem for path in MODULES} | {path.name for path in FOLDERS}
    places = {str(path.relative_to(PACKAGE).with_suffix("")) for path in [*MODULES, *FOLDERS]}
    for name in re.findall(r"`([a-z_]+(?:/[a-z_]+)+)/?`", text):
        if name.split("/")[0] in stems:
            assert any(place.endswith(name) for place in places) or (ROOT / name).exists(), name
