"""A recording with two robots in one place: the simulated one, and a real one as a log shows it."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from vrts.engine.batch import batch_of
from vrts.engine.run import Run
from vrts.report.assessment import Assessment
from vrts.report.picture.lighting import to_srgb
from vrts.report.picture.solids import Solid, body_solids, link_solids
from vrts.report.plain import one_line
from vrts.report.poses.followed import followed
from vrts.report.poses.quaternions import quaternions
from vrts.report.poses.sampled import times_of
from vrts.report.recording import APPLICATION
from vrts.report.recording.blueprint import BACKGROUND, EYE, TARGET
from vrts.report.recording.names import TIMELINE, Array, at_times, entity
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.model import Robot

REAL_COLOR = (235, 120, 30, 150)  # see-through
REAL_PATH = (235, 120, 30)
ERROR_NAMES = ("X", "Y", "Z")
JOINT_NAMES = tuple(f"JT{k}" for k in range(1, 7))
CURVE_COLORS = (
    (240, 100, 90),
    (110, 210, 120),
    (110, 160, 255),
    (240, 190, 70),
    (200, 130, 230),
    (120, 215, 220),
)
RADIUS_M = 0.0012


class Real(NamedTuple):
    """A real robot at n instants of a run."""

    times: Array  # shape (n,) [s]
    tool: Array  # in W, shape (n, 3) [m]
    path_errors: Array  # shape (n, 3) [mm]
    joints: Array | None  # shape (n, 6) [rad]; without them only the tool's path is shown
    joint_errors: Array | None  # shape (n, 6) [deg]


def write_overlay(a: Assessment, real: Real, words: str, path: Path) -> None:
    """Write a recording of a run and of a real robot over it.

    Args:
        a: With run and scene.
        real: The real robot.
        words: What is said beside the scene, in plain text.
        path: The file.
    """
    assert a.run is not None
    assert a.scene is not None
    stream = rr.RecordingStream(
        APPLICATION, recording_id=one_line(a.identifier), send_properties=False
    )
    with stream:
        stream.save(path, default_blueprint=_blueprint(real))
        times = times_of(a.run)
        states = batch_of(a.run.timeline).values(times)
        _send_robot("virtual", a.scene.robot, times, states, None)
        _send_bodies(a.run, times, states)
        if real.joints is not None:
            opening = batch_of(a.run.timeline).values(real.times)[:, 6:]
            q = np.column_stack((real.joints, opening))
            _send_robot("real", a.scene.robot, real.times, q, REAL_COLOR)
        rr.log(
            "world/real_path",
            rr.LineStrips3D([real.tool.astype(np.float32)], colors=[REAL_PATH], radii=[RADIUS_M]),
            static=True,
        )
        _curves("path_error", real.times, real.path_errors, ERROR_NAMES)
        if real.joint_errors is not None:
            _curves("joint_error", real.times, real.joint_errors, JOINT_NAMES)
        rr.log(
            "summary", rr.TextDocument(_markdown(words), media_type="text/markdown"), static=True
        )
    stream.flush()
    stream.disconnect()


def _send_robot(
    kind: str, robot: Robot, times: Array, states: Array, color: tuple[int, ...] | None
) -> None:
    """Send a robot, in one colour or as it is painted.

    Args:
        kind: Part of the paths: "virtual" or "real".
        robot: The robot.
        times: Shape (n,) [s].
        states: Joints [rad] and hand opening [m], shape (n, 7).
        color: Red, green, blue and how opaque; None: its own.
    """
    rotations, origins = link_frames(robot.arm, states[:, :6])
    flange = flange_of(robot.arm, rotations[6], origins[6])
    joints = {link.name: link.joint for link in robot.arm.links}
    sides = {finger.name: finger.side for finger in robot.gripper.fingers}
    for solid in link_solids(robot):
        k = joints.get(solid.name)
        turn, at = flange if k is None else (rotations[k], origins[k])
        shift = 0.5 * sides.get(solid.name, 0) * states[:, 6:] * turn[:, :, 1]
        place = f"world/{kind}/{entity(solid.name)}"
        _log_solid(place, solid, color)
        _send_poses(place, times, turn, at + shift)


def _send_bodies(run: Run, times: Array, states: Array) -> None:
    """Send what stands in the scene, and how it is carried."""
    arm = run.scene.robot.arm
    rotations, origins = link_frames(arm, states[:, :6])
    flange = flange_of(arm, rotations[6], origins[6])
    for number, solid in enumerate(body_solids(run.scene)):
        place = f"world/bodies/{entity(solid.name)}/{number}"
        _log_solid(place, solid, None)
        track = run.placements.get(solid.name)
        if track:
            _send_poses(place, times, *followed(track, times, *flange))
        else:
            X_WO = run.scene.body(solid.name).X_WO
            R = np.array(X_WO.rotation, np.float32).reshape(3, 3)
            rr.log(place, rr.Transform3D(translation=X_WO.translation, mat3x3=R), static=True)


def _log_solid(place: str, solid: Solid, color: tuple[int, ...] | None) -> None:
    corners = solid.surface.corners.reshape(-1, 3)
    if len(corners):
        own = to_srgb(np.array([solid.color], np.float32))[0]
        mesh = rr.Mesh3D(
            vertex_positions=corners.astype(np.float32),
            vertex_normals=solid.surface.normals.reshape(-1, 3).astype(np.float32),
            albedo_factor=own if color is None else color,
        )
        rr.log(place, mesh, static=True)


def _send_poses(place: str, times: Array, rotations: Array, origins: Array) -> None:
    """Send where something is, at the instants at which that changes."""
    changes = (np.diff(rotations, axis=0) != 0.0).any(axis=(1, 2))
    changes |= (np.diff(origins, axis=0) != 0.0).any(axis=1)
    kept = np.concatenate([[True], changes])
    columns = rr.Transform3D.columns(
        translation=origins[kept].astype(np.float32), quaternion=quaternions(rotations[kept])
    )
    rr.send_columns(place, at_times(times[kept]), columns)


def _curves(path: str, times: Array, values: Array, names: tuple[str, ...]) -> None:
    known = np.isfinite(values).all(axis=1)
    colors = CURVE_COLORS[: len(names)]
    rr.log(path, rr.SeriesLines(names=list(names), colors=colors), static=True)
    columns = rr.Scalars.columns(scalars=values[known].ravel())
    rr.send_columns(
        path, at_times(times[known]), columns.partition(np.full(int(known.sum()), len(names)))
    )


def _markdown(words: str) -> str:
    """Return lines as they are: in an indented block nothing means anything but itself."""
    return "\n".join(f"    {line}" for line in words.split("\n"))


def _blueprint(real: Real) -> rrb.Blueprint:
    scene = rrb.Spatial3DView(
        origin="/world",
        name="Both robots",
        background=BACKGROUND,
        line_grid=False,
        eye_controls=rrb.EyeControls3D(position=EYE, look_target=TARGET),
    )
    curves = [_view("path_error", "Path error [mm]")]
    if real.joint_errors is not None:
        curves.append(_view("joint_error", "Joint error [deg]"))
    words = rrb.TextDocumentView(origin="/summary", name="Summary")
    return rrb.Blueprint(
        rrb.Horizontal(scene, rrb.Vertical(*curves, words), column_shares=[3, 2]),
        rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
        collapse_panels=True,
    )


def _view(path: str, name: str) -> rrb.TimeSeriesView:
    return rrb.TimeSeriesView(
        origin=f"/{path}", name=name, plot_legend=rrb.PlotLegend(visible=True)
    )
