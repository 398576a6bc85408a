"""Rules of the house that no linter knows."""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator

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
    ("vrts.marking.by_hand.decisions.files", "fcntl"),
    ("vrts.marking.by_hand.decisions.files", "msvcrt"),
    ("vrts.marking.remote.dask_cluster", "dask_jobqueue"),
    ("vrts.marking.remote.mark_on_dask", "vrts.marking.remote.dask_cluster"),
    ("vrts.marking.submission.marker", "vrts.report.recording"),
    ("vrts.marking.submission.report_files", "vrts.report.recording"),
    ("vrts.course.front.login_pages", "vrts.live.entrance.provider.checking"),
    ("vrts.course.front.login_pages", "vrts.live.entrance.provider.provider"),
    ("vrts.live.callers.open_files", "resource"),
    ("vrts.marking.supervise.limits", "resource"),
    ("vrts.marking.supervise.staging", "fcntl"),
    ("vrts.validate.camera.compare", "vrts.report.recording.through_camera"),
    ("vrts.validate.log.log_formats", "vrts.validate.log.bags.joint_states"),
    ("vrts.validate.log.log_formats", "vrts.validate.log.matlab"),
    ("vrts.pipeline.pieces.qhull", "scipy.spatial"),
    # numpy, which most runs of programs do without: a third of the time that they take
    ("vrts.engine.hand.hand", "vrts.engine.hand.settle"),
    ("vrts.robots.urdf.serial_robot", "vrts.robots.urdf.hulls"),
    ("vrts.scene.handling.holds", "vrts.scene.handling.mesh_grips"),
    ("vrts.scene.handling.places", "vrts.scene.handling.mesh_grips"),
    ("vrts.scene.reading.form_section", "vrts.scene.reading.mesh_section"),
}
RUNS_TEXT = {"eval", "exec", "compile", "__import__"}
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


def faults(tree: ast.AST) -> Iterator[str]:
    """Yield where a module runs text of users, or hides an error."""
    for node in ast.walk(tree):
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(called, ast.Name) and called.id in RUNS_TEXT:
            yield f"{called.id} at {called.lineno}"
        if isinstance(node, ast.ExceptHandler):
            if node.type is None:
                yield f"bare except at {node.lineno}"
                continue
            only_pass = len(node.body) == 1 and isinstance(node.body[0], ast.Pass)
            if only_pass and "Exception" in ast.unparse(node.type):
                yield f"swallowed error at {node.lineno}"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("eval('1')", "eval at 1"),
        ("try:\n    f()\nexcept:\n    g()", "bare except at 3"),
        ("try:\n    f()\nexcept Exception:\n    pass", "swallowed error at 3"),
    ],
)
def test_faults_are_found(text: str, found: str) -> None:
    assert list(faults(ast.parse(text))) == [found]


def test_no_module_runs_user_text_or_hides_an_error() -> None:
    assert len(MODULES) > 1000
    assert {
        str(path): found
        for path in MODULES
        if (found := list(faults(ast.parse(path.read_text("utf-8")))))
    } == {}


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


def test_no_folder_is_too_full_to_be_seen_at_a_glance() -> None:
    held = {
        str(folder): len([path for path in folder.glob("*.py") if path.stem != "__init__"])
        for folder in [PACKAGE, *FOLDERS]
    }
    assert {name: count for name, count in held.items() if count > MOST_MODULES} == {}


def test_a_folder_says_what_it_is_for_what_comes_in_and_what_goes_out() -> None:
    for folder in FOLDERS:
        said = ast.get_docstring(ast.parse((folder / "__init__.py").read_text("utf-8"))) or ""
        assert len(said.splitlines()) <= MOST_LINES, folder
        assert re.search(r"^In(:| and out:)", said, re.M), f"{folder}: what comes in"
        assert re.search(r"\bOut:|\bIn and out:", said), f"{folder}: what goes out"


def test_circles_are_found() -> None:
    edges = {"a": frozenset("b"), "b": frozenset("c"), "c": frozenset("b"), "d": frozenset("a")}
    assert circles(edges) == [["b", "c"]]


def test_no_modules_import_each_other_in_a_circle() -> None:
    assert len(graph()) > 500
    assert circles(graph()) == []


def test_within_a_folder_imports_point_one_way() -> None:
    every = graph()
    for folder in [PACKAGE, *FOLDERS]:
        name = ".".join(folder.relative_to(ROOT).parts)
        assert circles(siblings(every, name)) == [], name


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
