"""The collision check knows no robot by name: one motion of the same shapes has one answer."""

from dataclasses import replace

import pytest

from tests.unit.robots.kinematics.test_serial_arm import serial
from tests.unit.robots.test_every_robot import PICK_AND_PLACE, run_in, scene_of
from vrts.base.pose import Z_AXIS, Pose, rotation_about
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import CollisionReport
from vrts.engine.run import Run
from vrts.geometry.shapes import Piece
from vrts.robots.model import Arm, Robot, SerialArm
from vrts.scene.clearance import clearance, placed_body, placed_robot
from vrts.scene.model import Scene

TOO_LOW = PICK_AND_PLACE.replace("  MOVES base1_put", "  MOVES base1_put:TRANS(0,0,40)")
PROGRAMS = [PICK_AND_PLACE, TOO_LOW]


def with_arm(scene: Scene, arm: Arm) -> Scene:
    return replace(scene, robot=Robot(arm, scene.robot.gripper))


def plain(scene: Scene) -> SerialArm:
    """Return the arm of a PUMA as six joints with the same links."""
    arm = scene.robot.arm
    return replace(serial(arm.name), links=arm.links, skipped_pairs=arm.skipped_pairs)


def twisted(arm: SerialArm, angle: float) -> SerialArm:
    """Return the same arm with the last frame turned about its axis, so that F is turned in it."""
    turn = Pose(rotation_about(Z_AXIS, angle), (0.0, 0.0, 0.0))
    back = turn.inverse()
    links = tuple(
        link
        if link.joint < 6
        else link._replace(pieces=tuple(Piece(p.shape, back @ p.X_OP) for p in link.pieces))
        for link in arm.links
    )
    joints = (*arm.joints[:5], arm.joints[5] @ turn)
    return replace(arm, joints=joints, links=links, X_LF=back @ arm.X_LF)


def same(first: CollisionReport, second: CollisionReport) -> None:
    assert len(first.contacts) == len(second.contacts)
    for a, b in zip(first.contacts, second.contacts, strict=True):
        assert (a.first, a.second, a.parts) == (b.first, b.second, b.parts)
        assert a.depth_m == pytest.approx(b.depth_m, abs=2e-5)
        assert a.start_s == pytest.approx(b.start_s, abs=2e-3)
    assert (first.clearance is None) is (second.clearance is None)
    if first.clearance is not None and second.clearance is not None:
        assert first.clearance.distance_m == pytest.approx(second.clearance.distance_m, abs=2e-5)
        assert first.clearance.bodies == second.clearance.bodies


@pytest.mark.parametrize("program", PROGRAMS, ids=["clear", "too low"])
def test_a_puma_as_six_joints_touches_what_the_puma_touches(program: str) -> None:
    scene = scene_of("puma560")
    run = run_in(scene, program)
    same(check_collisions(scene, run), check_collisions(with_arm(scene, plain(scene)), run))


@pytest.mark.parametrize("program", PROGRAMS, ids=["clear", "too low"])
def test_how_the_last_frame_is_turned_changes_nothing(program: str) -> None:
    scene = scene_of("puma560")
    run = run_in(scene, program)
    other = with_arm(scene, twisted(plain(scene), 0.7))
    same(check_collisions(scene, run), check_collisions(other, run))


def sampled(scene: Scene, run: Run, samples: int) -> float:
    """Return the smallest distance of the bare arm from the table, by looking often."""
    table = placed_body(scene.body("table"))
    least = float("inf")
    for number in range(samples + 1):
        state = run.at(run.horizon_s * number / samples)
        parts = placed_robot(scene.robot, state.configuration, state.hand_opening)
        least = min(least, *(clearance(part, table, least) for part in parts[1:]))
    return least


@pytest.mark.parametrize("robot", ["ur5", "urdf"])
def test_no_sample_is_nearer_than_the_certified_clearance(robot: str) -> None:
    scene = scene_of(robot)
    run = run_in(scene, ".PROGRAM pick\n  MOVE safe\n  MOVE base1_put\n  BREAK\n.END\n")
    without = replace(
        scene, bodies=tuple(body for body in scene.bodies if body.name in ("floor", "table"))
    )
    report = check_collisions(without, run)
    assert report.clearance is not None
    assert "table" in report.clearance.bodies
    least = sampled(scene, run, 300)
    assert least >= report.clearance.distance_m - 1e-5
    assert least < report.clearance.distance_m + 2e-3
