"""A class marked by a real SLURM, where there is one that takes jobs from this machine."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.unit.marking.remote.support import CLASS, configured, files, task
from vrts.base.diagnostic import Diagnostic
from vrts.marking.layout import Layout
from vrts.marking.marking import mark_class
from vrts.marking.remote.backend import Backend, Scheduler
from vrts.marking.remote.mark_on_dask import mark_on_dask
from vrts.marking.remote.merge import merge
from vrts.marking.remote.plan import make_plan, read_key, write_plan
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place


@pytest.fixture(scope="module", autouse=True)
def slurm() -> None:
    """Skip where no SLURM takes jobs from this machine."""
    if shutil.which("sbatch") is None:
        pytest.skip("no SLURM")
    try:
        asked = subprocess.run(["sinfo", "-h"], capture_output=True, check=False, timeout=5.0)
    except subprocess.TimeoutExpired:
        pytest.skip("SLURM does not answer")
    if asked.returncode != 0 or b"idle" not in asked.stdout:
        pytest.skip("SLURM has no idle machine")


def test_an_array_of_jobs_marks_a_class(tmp_path: Path) -> None:
    marker = Marker(Place(task(tmp_path / "lab")), Wanted(pages=False))
    write_plan(make_plan(marker, CLASS, 2), tmp_path / "plan")
    run = (
        f"{sys.executable} -m vrts.cli.main grade run"
        " plan/shards/shard-$(printf %02d $SLURM_ARRAY_TASK_ID).json -o results"
    )
    command = ["sbatch", "--wait", "--array=1-2", "--mem=2G", "--wrap", run]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    results = sorted((tmp_path / "results").glob("*.zip"))
    merged = merge(read_key(tmp_path / "plan"), results, Layout(tmp_path / "there"))
    assert merged.findings == ()
    list(mark_class(marker, CLASS, Layout(tmp_path / "here")))
    assert files(tmp_path / "there") == files(tmp_path / "here")


def test_dask_workers_in_jobs_mark_a_class(tmp_path: Path) -> None:
    marker = Marker(Place(task(tmp_path / "lab")), Wanted(pages=False))
    list(mark_class(marker, CLASS, Layout(tmp_path / "here")))
    said: list[Diagnostic] = []
    ours = {"cores": 1, "memory": "2GB", "interface": "lo", "log-directory": str(tmp_path / "logs")}
    with configured(Scheduler.SLURM, ours):
        found = mark_on_dask(
            marker,
            CLASS,
            Layout(tmp_path / "there"),
            Backend(Scheduler.SLURM),
            jobs=1,
            said=said.append,
        )
        assert {done.entry for done in found} == set(CLASS)
    assert said == []
    assert files(tmp_path / "there") == files(tmp_path / "here")
