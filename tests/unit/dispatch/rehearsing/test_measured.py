"""What is measured of LinuxCNC's motion, shown with robots whose faults are known."""

from pathlib import Path

import numpy as np
import pytest

from tests.support_commands import vrts_text
from tests.support_programs import ran
from vrts.base.units import DEG, MM
from vrts.dispatch.rehearsing.log_text import log_text
from vrts.dispatch.rehearsing.measured import Stretch, courses, extra, measured
from vrts.dispatch.rehearsing.page import rehearsal_page
from vrts.dispatch.rehearsing.place import laid_out
from vrts.dispatch.rehearsing.played import changes
from vrts.dispatch.rehearsing.rehearse import NEEDED, Rehearsal, expected
from vrts.dispatch.rehearsing.samples import Samples, read_samples
from vrts.engine.batch import batch_of
from vrts.engine.run import Run
from vrts.pipeline.refused import Refused
from vrts.scene.model import Scenario
from vrts.validate.log.log import GivenLog, read_log
from vrts.validate.sampling import extent_of

PLACES = ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\nc 900 -200 50 90 60 0\n.END\n"
STEPS = "MOVE a\nBREAK\nMOVES b\nMOVE a\nBREAK\nMOVES c\nBREAK\nSET x = a"
PAUSE_S = 0.03


@pytest.fixture(scope="module")
def run() -> Run:
    return ran(f".PROGRAM main\n{STEPS}\n.END\n{PLACES}")


def robot(run: Run, *, late: float = 1.0, off_deg: float = 0.0, until: int = 99) -> Samples:
    """Return what a robot would do that is slower, or has a joint that stands off, from motion 2.

    Its pauses are other than the run's.
    """
    batch = batch_of(run.timeline)
    rows = [batch.values(np.zeros(200))[:, :6]]
    numbers = [np.zeros(200)]
    for k, motion in enumerate(run.motions[:until], start=1):
        count = round((motion.end_s - motion.start_s) * late / 1e-3)
        times = motion.start_s + np.arange(1, count + 1) * 1e-3 / late
        joints = batch.values(np.minimum(times, motion.end_s))[:, :6]
        joints[:, 0] += off_deg * DEG * (k > 1)
        rows.append(joints)
        numbers.append(np.full(count, k))
        if not motion.blended:
            still = round(PAUSE_S / 1e-3)
            rows.append(np.repeat(joints[-1:], still, axis=0))
            numbers.append(np.full(still, k))
    return Samples(np.concatenate(rows), np.concatenate(numbers).astype(np.int64), 0)


def worst(found: tuple[Stretch, ...]) -> tuple[float, float]:
    return max(s.path_mm for s in found), max(s.equal_mm for s in found)


def test_a_course_is_the_error_of_its_stretch_over_time(run: Run) -> None:
    """From motion 2 on joint 1 stands a tenth of a degree off, and the tool with it."""
    samples = robot(run, off_deg=0.1)
    stretches = measured(run, samples)
    found = courses(run, samples, stretches)
    assert [one.stretch for one in found] == list(stretches)
    for k, (one, motion) in enumerate(zip(found, stretches, strict=True)):
        assert float(np.abs(one.joints).max()) / DEG == pytest.approx(motion.joints_deg)
        assert float(one.equal.max()) / MM == pytest.approx(motion.equal_mm)
        assert float(one.path.max()) / MM == pytest.approx(motion.path_mm)
        middle = one.joints[len(one.joints) // 2] / DEG
        assert middle[0] == pytest.approx(0.1 * (k > 0), abs=0.01)
        assert middle[1:] == pytest.approx(np.zeros(5), abs=0.03)
    starts = [float(one.times[0]) for one in found]
    assert starts == sorted(starts)
    assert starts[0] == pytest.approx(run.motions[0].start_s, abs=0.05)


def test_the_page_draws_errors_of_all_motions_and_of_each(run: Run) -> None:
    samples = robot(run, off_deg=0.1)
    stretches = measured(run, samples)
    page = rehearsal_page(Rehearsal(run, samples, stretches, (), ()), "<folder>")
    assert page.count("<svg") == 2 * (1 + len(stretches))
    assert page.count("<details>") == len(stretches)
    assert "JT1, JT2, JT3, JT4, JT5, JT6 over time, in deg" in page
    assert "equal time, path over time, in mm" in page
    assert "<folder>" not in page
    nothing = Samples(np.zeros((0, 6)), np.zeros(0, np.int64), 0)
    assert "<svg" not in rehearsal_page(Rehearsal(run, nothing, (), (), ()), "folder")


def test_a_robot_that_does_the_same_is_the_same(run: Run) -> None:
    found = measured(run, robot(run))
    assert [(s.first, s.last, s.rounded) for s in found] == [
        (1, 1, False),
        (2, 3, True),
        (4, 4, True),
    ]
    path, equal = worst(found)
    assert path < 0.001
    assert equal < 0.02
    assert all(s.holds for s in found)
    assert max(abs(s.longer_s) for s in found) < 1e-4
    assert extra(run, robot(run)) == 0


def test_a_slow_robot_keeps_the_path_and_not_the_time(run: Run) -> None:
    found = measured(run, robot(run, late=1.05))
    path, equal = worst(found)
    assert path < 0.001
    assert equal > 5.0
    assert not any(s.holds for s in found)
    assert found[0].longer_s == pytest.approx(
        0.05 * (run.motions[0].end_s - run.motions[0].start_s), rel=0.15
    )


def test_a_joint_that_stands_off_is_seen_as_far_as_it_is(run: Run) -> None:
    first, *others = measured(run, robot(run, off_deg=0.1))
    assert first.holds
    for s in others:
        assert s.end_mm == pytest.approx(0.1 * DEG * 930.0, rel=0.1)
        assert not s.holds


def test_a_motion_that_is_never_made_is_missing(run: Run) -> None:
    *_, last = measured(run, robot(run, until=3))
    assert last.missing
    assert not last.holds
    more = robot(run)
    more.motions[-1] = 6
    assert extra(run, more) == 2


@pytest.mark.parametrize("rounded", [False, True])
@pytest.mark.parametrize("bound", ["path_mm", "equal_mm", "end_mm", "longer_s"])
def test_each_bound_of_the_sheet_counts_by_itself(bound: str, rounded: bool) -> None:
    near = Stretch(1, 1, "main 1", rounded, 0.009, 0.049, 0.009, 0.0, -0.0019, 0.0)
    allowed = {
        "path_mm": 0.15 if rounded else 0.01,
        "equal_mm": 1.5 if rounded else 0.05,
        "end_mm": 0.01,
        "longer_s": 0.002,
    }[bound]
    assert near.holds
    assert near._replace(**{bound: 0.99 * allowed}).holds
    assert not near._replace(**{bound: 1.01 * allowed}).holds
    assert not near._replace(missing=True).holds


def test_the_log_is_read_by_validate(run: Run) -> None:
    text = "".join(log_text(robot(run)))
    log = read_log(GivenLog("linuxcnc.csv", (text.encode(),)), extent_of(run))
    assert log.joints is not None
    assert log.joints[-1] == pytest.approx(run.motions[-1].goal, abs=1e-6)


def test_rows_of_the_sampler_are_read_and_what_is_cut_short_is_left_out() -> None:
    rows = ["7 0 -90 -90 0 0 0 0", "8 1 -90 -90 0 0 0 1", "overrun", "12 1 -9"]
    found = read_samples("\n".join(rows))
    assert found.joints[:, 2] == pytest.approx([90 * DEG, 90 * DEG])
    assert found.motions.tolist() == [0, 1]
    assert not len(read_samples("").joints)


def test_inputs_are_played_by_the_motion_under_way() -> None:
    inputs = ((0.0, 1001, True), (3.0, 1002, True), (3.5, 1002, False))
    run = ran(
        f".PROGRAM main\nMOVE a\nBREAK\nDELAY 2\nMOVE b\n.END\n{PLACES}",
        scenario=Scenario(inputs=inputs),
    )
    start = run.motions[0].start_s
    first, second, third = changes(run)
    assert tuple(first) == (0, 0.0, 1001, True)
    assert tuple(second) == (1, pytest.approx(3.0 - start, abs=0.028), 1002, True)  # at a tick
    assert third.motion == 1


def test_what_cannot_be_rehearsed_is_told(tmp_path: Path) -> None:
    said = vrts_text("dispatch", "rehearse", tmp_path)
    assert said.returncode == 1
    assert "V874" in said.stderr
    assert "has no `program.ngc`" in said.stderr


def test_a_link_in_a_folder_is_refused(tmp_path: Path) -> None:
    for name in NEEDED:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / "library" / "v_more.ngc").symlink_to("/etc/hostname")
    with pytest.raises(Refused) as caught:
        expected(tmp_path)
    assert caught.value.diagnostics[0].headline.endswith("v_more.ngc` is a link")


def test_only_the_copy_of_a_folder_belongs_to_who_carries_it_out(tmp_path: Path) -> None:
    exported, room = tmp_path / "exported", tmp_path / "room"
    room.mkdir()
    for name in NEEDED:
        (exported / name).parent.mkdir(parents=True, exist_ok=True)
        (exported / name).touch()
    place = laid_out(exported, room, (), root=False)
    assert place.parent == room
    assert place.stat().st_mode & 0o777 == 0o700
    assert not (place / "enter").exists()
    assert (room / "enter").stat().st_mode & 0o022 == 0
