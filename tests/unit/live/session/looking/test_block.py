"""Any moment of the past, as the browser works it out from a block, is what it was."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.unit.live.session.again.test_replay import eventful
from tests.unit.live.session.looking.played import coordinates, in_force
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import BLOCK
from vrts.live.session.looking.block import STOPPED, block
from vrts.live.session.views.frame import output_bits
from vrts.report.page.viewer_data import pose_numbers


def plain(value: object) -> dict[str, Any]:
    """Return a block as it comes to the browser."""
    return json.loads(json.dumps(value))


def same_as_run(driven: Driven, number: int, reaches_s: float = 0.0) -> dict[str, Any]:
    """Compare a block with the run at many moments; return it."""
    run = driven.session.run
    found = plain(block(run, number, reaches_s))
    moments = int(100 * (found["until"] - found["begin"])) + 1
    for t in (found["begin"] + 0.01 * k for k in range(moments)):
        state = run.at(min(t, found["until"]))
        expected = [*state.configuration, state.hand_opening]
        assert coordinates(found, t) == pytest.approx(expected, abs=1e-6), t
        assert in_force(found["tools"], t)["X"] == pytest.approx(pose_numbers(state.X_FT))
        assert in_force(found["outputs"], t)[1] == output_bits(state.signals), t
        for name, placement in state.placements.items():
            row = in_force(found["placements"][name], t)
            assert (row["lie"], row["X"]) == (placement.lie.value, pose_numbers(placement.X)), t
        _, number_of_step, _ = in_force(found["lines"], t)
        if state.cause is not None and number_of_step >= 0:
            assert found["steps"][number_of_step]["text"] == state.cause.span.text.strip()
    return found


def test_a_block_gives_back_arm_hand_bodies_outputs_and_line(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    eventful(driven)
    found = same_as_run(driven, 0)
    assert not found["whole"]
    assert found["until"] == driven.session.growing.time_s < BLOCK
    programs = {step["program"] for step in found["steps"]}
    assert programs == {"", "wave"}
    runs = [running for _, _, running in found["lines"]]
    assert True in runs
    assert not runs[-1]
    texts = [row["text"] for row in found["marks"]]
    assert STOPPED in texts
    assert [text for text in texts if "starts" in text] == ["program wave starts"]
    assert any("grasped" in text for text in texts)
    assert [row["t"] for row in found["marks"]] == sorted(row["t"] for row in found["marks"])


def test_a_program_that_is_over_no_longer_runs(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    text = '.PROGRAM wave\nMOVE #PPOINT(10,-90,90,0,0,0)\nTYPE "done"\n.END\n'
    driven.act(do.Upload("wave.v2", text))
    driven.run(0.05)
    driven.typed("EXECUTE wave", seconds=10.0)
    found = plain(block(driven.session.run, 0, 0.0))
    over = next(row["t"] for row in found["marks"] if row["text"].startswith("program over"))
    assert in_force(found["lines"], over - 1e-3)[2]
    assert not in_force(found["lines"], over + 1e-3)[2]


def test_a_block_that_nothing_happens_in_has_one_row_of_each(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(130.0, beat_s=1.0)
    found = same_as_run(driven, 1)
    assert (found["begin"], found["until"], found["whole"]) == (60.0, 120.0, True)
    assert [len(found[name]) for name in ("lines", "tools", "outputs", "marks")] == [1, 1, 1, 0]


def test_a_motion_goes_on_over_the_border_of_two_blocks(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(BLOCK - 1.0, beat_s=1.0)
    driven.typed("DO DRIVE 1,40,10", seconds=8.0)
    run = driven.session.run
    moving = [motion for motion in run.motions if motion.start_s < BLOCK < motion.end_s]
    assert len(moving) == 1
    for number in (0, 1):
        same_as_run(driven, number)
    assert abs(coordinates(plain(block(run, 1, 0.0)), BLOCK)[0]) > 0.01, "it is on its way"


def test_a_block_of_what_is_in_the_file_is_the_one_that_it_was(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    eventful(driven)
    driven.run(BLOCK, beat_s=0.5)
    growing = driven.session.growing
    before = plain(block(driven.session.run, 0, 0.0))
    driven.run(1400.0, beat_s=1.0)
    assert growing.known_from_s > BLOCK
    assert growing.reaches_s == 0.0
    run = growing.run_of(0.0, BLOCK)
    assert run is not None
    assert plain(block(run, 0, 0.0)) == before


@pytest.mark.thorough
def test_of_a_past_that_is_forgotten_in_part_the_rest_is_told(tmp_path: Path) -> None:
    driven = Driven(tmp_path, history=1)
    eventful(driven)
    driven.run(1400.0, beat_s=1.0)
    growing = driven.session.growing
    assert growing.reaches_s > BLOCK
    number = int(growing.reaches_s // BLOCK)
    found = same_as_run(driven, number, growing.reaches_s)
    assert found["begin"] == found["reaches"] == growing.reaches_s
    assert growing.run_of(0.0, BLOCK) is None
