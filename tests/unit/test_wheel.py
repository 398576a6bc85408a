"""The built wheel, in an environment and a folder of its own, marks the example."""

import json
import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_site import built_site

NEEDED = (
    "vrts/dispatch/profiles/mark2-val2.toml",
    "vrts/lang/grammar/grammar.lark",
    "vrts/manual/language/signals.md",
    "vrts/pages/V301.md",
    "vrts/site/built/index.html",
    "vrts/site/built/searchindex.js",
    "vrts/library/scenes/cans-on-bases/scene.toml",
    "vrts/library/examples/01-cans-on-bases/solution.v2",
    "vrts/web/viewer/viewer.js",
    "vrts/py.typed",
    "vrts/__init__.pyi",
    "vrts/schemas/scene.schema.json",
    "vrts/library/examples/06-notebook/from-python.ipynb",
)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    built_site()  # where it is built already, a wheel takes it from there
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(out)]
    subprocess.run([*command, str(ROOT)], check=True, capture_output=True)
    return next(out.glob("vrts-*.whl"))


@pytest.mark.thorough
def test_the_wheel_holds_all_data(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    assert set(NEEDED) - names == set()
    assert any(name.startswith("vrts/web/vendor/three/") for name in names)
    assert any(name.startswith("vrts/web/vendor/codemirror/") for name in names)
    assert any(name.endswith(".data/data/share/man/man1/vrts.1") for name in names)
    assert not any(name.startswith("vrts/site/built/man/") for name in names)


@pytest.mark.thorough
def test_the_installed_wheel_marks_the_example(wheel: Path, tmp_path: Path) -> None:
    """Dependencies come from the environment of the tests, by a path; vrts itself does not."""
    home = tmp_path / "env"
    venv.create(home, with_pip=False)
    site = home / "lib" / f"python3.{sys.version_info.minor}" / "site-packages"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    added = f"import site; site.addsitedir({sysconfig.get_path('purelib')!r})\n"
    (site / "dependencies.pth").write_text(added)
    python = home / "bin" / "python"
    alone = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    where = subprocess.run(
        [python, "-c", "import vrts; print(vrts.__file__)"],
        cwd=tmp_path,
        env=alone,
        capture_output=True,
        text=True,
        check=True,
    )
    assert where.stdout.startswith(str(site))
    result = subprocess.run(
        [python, "-m", "vrts.cli.main", "grade", "01-cans-on-bases", "--format", "json"],
        cwd=tmp_path,
        env=alone,
        capture_output=True,
        text=True,
        check=True,
    )
    marks = {row["id"]: row["final"] for row in json.loads(result.stdout)["rows"]}
    assert marks["solution"] == 10.0
    assert marks["hits-base"] == 7.0
