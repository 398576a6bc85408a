"""Two years of a class, marked once."""

import shutil
from pathlib import Path

import pytest

from tests.unit.marking.personal.support import EXAMPLE, call, decided, download, ids_of
from vrts.marking.layout import Layout


@pytest.fixture(scope="session")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Mark a class with all that may be kept, and the class of the next year with it as corpus."""
    home = tmp_path_factory.mktemp("years")
    first = download(home / "in-2025")
    second = home / "in-2026"
    shutil.copytree(first, second)
    shutil.rmtree(second / "Querulin Zwackelmann_4711_assignsubmission_file_")
    assert call("grade", EXAMPLE, first, "-o", home / "2025").exit_code == 0
    done = call("grade", EXAMPLE, second, "-o", home / "2026", "--corpus", home / "2025")
    assert done.exit_code == 0, done.output
    layout = Layout(home / "2025")
    decided(layout, ids_of(home / "2025"))
    words = ("--to", "csv", "--to", "folders", "--to", "moodle-feedback", "--to", "junit")
    done = call("grade", "export", home / "2025", *words)
    draft = layout.staging / "elsewhere-1-a"
    draft.mkdir(parents=True)
    (draft / "report.html").write_text("Querulin Zwackelmann")
    (layout.staff / "exports" / "notes.csv").write_text("Ben Otto,1\n")
    return home
