"""Recordings for the Rerun viewer: the only door to rerun, imported only when one is written.

Everything is sent in columns, never frame by frame. Time is in seconds on the timeline "t". Static
things are logged once; links, hand and bodies get poses only while they move.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt
import rerun as rr
import rerun.blueprint as rrb

from vrts.base.pose import Pose
from vrts.engine.batch import Batch
from vrts.engine.events import Printed
from vrts.engine.records import GRAVITY, Lie, Placement
from vrts.geometry.mesh import tessellate
from vrts.geometry.shapes import Piece
from vrts.report.assessment import Assessment
from vrts.report.event_words import event_text
from vrts.report.plain import one_line
from vrts.report.replay_data import contact_sentence
from vrts.report.replay_lanes import process_lines, robot_lines, signal_spans
from vrts.robots.batch import flange_of, link_frames

Array = npt.NDArray[np.float64]

EYE, TARGET = (3.4, -2.4, 1.3), (0.5, 0.0, -0.2)  # [m] in W
RATE = 50.0  # poses a second, as the original system broadcast them
TIMELINE = "t"
ARM_COLOR = (214, 205, 190)
HAND_COLOR = (70, 74, 80)
PATH_COLOR = (24, 100, 171)
ALARM_COLOR = (225, 29, 42)
LEVELS = {"fault": "ERROR", "note": "WARN", "motion": "INFO", "output": "INFO", "signal": "INFO"}
MOST_CONTACTS = 100  # markers


def write_recording(a: Assessment, path: Path) -> None:
    """Write a recording of a run.

    Raises:
        ValueError: There is no run to record.
    """
    if a.run is None or a.scene is None:
        raise ValueError("nothing was run")
    stream = rr.RecordingStream("vrts", recording_id=a.identifier, send_properties=False)
    with stream:
        stream.save(path, default_blueprint=_blueprint())
        _static(a)
        times = times_of(a)
        coordinates, rates = _coordinates(a, times)
        _moving(a, times, coordinates)
        _contacts(a)
        _plots(a, times, coordinates, rates)
        _lanes(a)
        _texts(a)
    stream.flush()
    stream.disconnect()


def times_of(a: Assessment) -> Array:
    """Return the instants that are recorded: at a steady rate, and the end."""
    assert a.run is not None
    end = a.run.horizon_s
    steady = np.arange(0.0, end, 1.0 / RATE)
    return np.unique(np.concatenate([steady, [end]]))


def _blueprint() -> rrb.Blueprint:
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(
                rrb.Spatial3DView(
                    origin="/world",
                    name="Scene",
                    eye_controls=rrb.EyeControls3D(position=EYE, look_target=TARGET),
                ),
                rrb.StateTimelineView(origin="/lanes", name="Lines, gripper and signals"),
                rrb.TextLogView(origin="/log", name="Program"),
                row_shares=[5, 2, 2],
            ),
            rrb.Vertical(
                rrb.Tabs(
                    rrb.TimeSeriesView(origin="/range", name="Joints [% of half the range]"),
                    rrb.TimeSeriesView(origin="/joints", name="Joints [deg]"),
                ),
                rrb.TimeSeriesView(origin="/speed", name="Joint speed [% of limit]"),
                rrb.TimeSeriesView(origin="/clearance", name="Clearance [mm]"),
                rrb.TimeSeriesView(origin="/hand", name="Hand opening [mm]"),
                rrb.TextDocumentView(origin="/summary", name="Summary"),
            ),
            column_shares=[3, 2],
        ),
        rrb.TimePanel(timeline=TIMELINE, state="expanded"),
        collapse_panels=True,
    )


def _mesh(pieces: Sequence[Piece], color: tuple[int, int, int]) -> rr.Mesh3D:
    vertices: list[Array] = []
    triangles: list[npt.NDArray[np.int32]] = []
    offset = 0
    for piece in pieces:
        mesh = tessellate(piece)
        corners = np.asarray(mesh.vertices)
        vertices.append(corners)
        triangles.append(np.asarray(mesh.triangles) + offset)
        offset += len(corners)
    # every triangle has corners of its own, so that faces look flat
    faces = np.concatenate(vertices)[np.concatenate(triangles)]
    normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return rr.Mesh3D(
        vertex_positions=faces.reshape(-1, 3).astype(np.float32),
        triangle_indices=np.arange(3 * len(faces), dtype=np.uint32).reshape(-1, 3),
        vertex_normals=np.repeat(normals, 3, axis=0).astype(np.float32),
        albedo_factor=[*color, 255],
    )


def _static(a: Assessment) -> None:
    assert a.scene is not None
    robot = a.scene.robot
    rr.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    for link in robot.arm.links:
        if link.pieces:
            rr.log(f"world/robot/{_path(link.name)}", _mesh(link.pieces, ARM_COLOR), static=True)
    rr.log("world/robot/hand", _mesh(robot.gripper.body, HAND_COLOR), static=True)
    for finger in robot.gripper.fingers:
        path = f"world/robot/{_path(finger.name)}"
        rr.log(path, _mesh(finger.pieces, HAND_COLOR), static=True)
    for body in a.scene.bodies:
        color = tuple(round(255 * _srgb(part)) for part in body.color)
        path = f"world/{_path(body.name)}"
        rr.log(path, _mesh(body.pieces, (color[0], color[1], color[2])), static=True)
        rr.log(
            path,
            _transform(body.X_WO),
            static=a.run is None or body.name not in a.run.placements,
        )
    rr.log("summary", rr.TextDocument(_summary(a), media_type="text/markdown"), static=True)


def _moving(a: Assessment, times: Array, states: Array) -> None:
    assert a.run is not None
    assert a.scene is not None
    robot = a.scene.robot
    rotations, origins = link_frames(robot.arm, states[:, :6])
    moving = np.concatenate([[True], np.any(np.abs(np.diff(states, axis=0)) > 1e-9, axis=1)])
    moving[:-1] |= moving[1:]
    for link in robot.arm.links:
        if link.pieces:
            k = link.joint
            _send(link.name, "robot/", times[moving], rotations[k][moving], origins[k][moving])
    flange_r, flange_p = flange_of(robot.arm, rotations[6], origins[6])
    _send("hand", "robot/", times[moving], flange_r[moving], flange_p[moving])
    for finger in robot.gripper.fingers:
        shift = 0.5 * finger.side * states[:, 6:7] * flange_r[:, :, 1]
        at = (flange_p + shift)[moving]
        _send(finger.name, "robot/", times[moving], flange_r[moving], at)
    _tool_path(a, times, flange_r, flange_p)
    for name, track in a.run.placements.items():
        turn, at = _track(track, times, flange_r, flange_p)
        changes = np.any(turn[1:] != turn[:-1], axis=(1, 2)) | np.any(at[1:] != at[:-1], axis=1)
        keep = np.concatenate([[True], changes])
        keep[:-1] |= keep[1:]
        _send(name, "", times[keep], turn[keep], at[keep])


def _tool_path(a: Assessment, times: Array, flange_r: Array, flange_p: Array) -> None:
    """Draw the way of the tool's tip, with the tool in force at every instant."""
    assert a.run is not None
    tools = [a.run.scene.X_FT, *(m.X_FT for m in a.run.motions)]
    starts = np.array([m.start_s for m in a.run.motions])
    tip = np.array([tool.translation for tool in tools])
    at = tip[np.searchsorted(starts, times, side="right")]
    points = flange_p + np.einsum("nij,nj->ni", flange_r, at)
    strip = rr.LineStrips3D([points.astype(np.float32)], colors=[PATH_COLOR], radii=[0.0015])
    rr.log("world/tool_path", strip, static=True)


def _contacts(a: Assessment) -> None:
    """Mark where contacts are deepest, from their first to their last moment."""
    report = a.judgement.collisions if a.judgement else None
    for number, c in enumerate(report.contacts[:MOST_CONTACTS] if report else (), start=1):
        path = f"world/contacts/{number}"
        rr.send_columns(
            path,
            [rr.TimeColumn(TIMELINE, duration=[c.start_s])],
            rr.Points3D.columns(
                positions=[c.point],
                radii=[0.02],
                colors=[ALARM_COLOR],
                labels=[contact_sentence(c)],
            ),
        )
        rr.send_columns(
            path,
            [rr.TimeColumn(TIMELINE, duration=[max(c.end_s, c.start_s + 1e-3)])],
            rr.Clear.columns(is_recursive=[False]),
        )


def _track(
    track: Sequence[Placement], times: Array, flange_r: Array, flange_p: Array
) -> tuple[Array, Array]:
    """Return where a body is: rotations, shape (n, 3, 3), and origins, shape (n, 3) [m]."""
    turn, at = np.empty((len(times), 3, 3)), np.empty((len(times), 3))
    for placement in track:
        now = times >= placement.start_s
        R, p = np.array(placement.X.rotation).reshape(3, 3), np.array(placement.X.translation)
        if placement.lie is Lie.HELD:
            turn[now] = flange_r[now] @ R
            at[now] = flange_p[now] + flange_r[now] @ p
            continue
        turn[now], at[now] = R, p
        if placement.lie is Lie.FALLING:
            at[now, 2] -= 0.5 * GRAVITY * (times[now] - placement.start_s) ** 2
    return turn, at


def _quaternions(rotations: Array) -> npt.NDArray[np.float32]:
    """Return unit quaternions x, y, z, w, shape (n, 4), from the largest part of each."""
    r = rotations
    trace = np.einsum("nii->n", r)
    parts = np.stack([r[:, 0, 0], r[:, 1, 1], r[:, 2, 2], trace], axis=1)
    chosen = np.argmax(parts, axis=1)
    q = np.empty((len(r), 4))
    for k in range(3):
        rows, i, j = chosen == k, (k + 1) % 3, (k + 2) % 3
        m = r[rows]
        q[rows, k] = 1.0 + m[:, k, k] - m[:, i, i] - m[:, j, j]
        q[rows, i] = m[:, i, k] + m[:, k, i]
        q[rows, j] = m[:, j, k] + m[:, k, j]
        q[rows, 3] = m[:, j, i] - m[:, i, j]
    rows, m = chosen == 3, r[chosen == 3]
    q[rows, 3] = 1.0 + trace[rows]
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        q[rows, k] = m[:, j, i] - m[:, i, j]
    return (q / np.linalg.norm(q, axis=1, keepdims=True)).astype(np.float32)


def _coordinates(a: Assessment, times: Array) -> tuple[Array, Array]:
    """Return joints [rad] and hand opening [m], shape (n, 7), and their rates."""
    assert a.run is not None
    if not a.run.timeline.segments:
        state = a.run.at(0.0)
        still = np.array([(*state.configuration, state.hand_opening)])
        return np.repeat(still, len(times), axis=0), np.zeros((len(times), 7))
    batch = Batch(a.run.timeline.segments)
    return batch.values(times), batch.rates(times)


def _send(name: str, folder: str, times: Array, rotations: Array, origins: Array) -> None:
    rr.send_columns(
        f"world/{folder}{_path(name)}",
        [rr.TimeColumn(TIMELINE, duration=times)],
        rr.Transform3D.columns(
            translation=origins.astype(np.float32), quaternion=_quaternions(rotations)
        ),
    )


def _plots(a: Assessment, times: Array, states: Array, rates: Array) -> None:
    assert a.run is not None
    assert a.scene is not None
    arm = a.scene.robot.arm
    lower, upper = np.array(arm.lower), np.array(arm.upper)
    share = (2.0 * states[:, :6] - lower - upper) / (upper - lower)
    names = [f"JT{k}" for k in range(1, 7)]
    column = [rr.TimeColumn(TIMELINE, duration=times)]
    count = np.full(len(times), 6)
    for path, values in (
        ("joints", np.degrees(states[:, :6])),
        ("range", 100.0 * share),
        ("speed", 100.0 * rates[:, :6] / np.array(arm.speed)),
    ):
        rr.log(path, rr.SeriesLines(names=names), static=True)
        rr.send_columns(path, column, rr.Scalars.columns(scalars=values.ravel()).partition(count))
    rr.log("hand", rr.SeriesLines(names=["opening"]), static=True)
    rr.send_columns("hand", column, rr.Scalars.columns(scalars=1000.0 * states[:, 6]))
    if a.clearance:
        rows = np.array(a.clearance)
        rr.log("clearance", rr.SeriesLines(names=["smallest distance"]), static=True)
        rr.send_columns(
            "clearance",
            [rr.TimeColumn(TIMELINE, duration=rows[:, 0])],
            rr.Scalars.columns(scalars=1000.0 * rows[:, 1]),
        )
    limits = np.array([100.0, -100.0])
    for path in ("speed/limit", "range/limit"):
        rr.log(path, rr.SeriesLines(names=["limit", "limit"]), static=True)
        rr.send_columns(
            path,
            [rr.TimeColumn(TIMELINE, duration=times[[0, -1]])],
            rr.Scalars.columns(scalars=np.tile(limits, 2)).partition(np.array([2, 2])),
        )


def _lanes(a: Assessment) -> None:
    """Send lines at work, what is held, and signals, as states that follow one another."""
    assert a.run is not None
    rows = [(t, f"line {line}") for t, line in robot_lines(a.run, a.source)]
    _lane("program", rows)
    _lane("process", [(t, f"line {line}") for t, line in process_lines(a.run, a.source)])
    held = [
        (p.start_s, p.end_s, one_line(body))
        for body, track in a.run.placements.items()
        for p in track
        if p.lie is Lie.HELD
    ]
    _lane("gripper", _states(held, "empty", a.run.horizon_s))
    for number, on in signal_spans(a.run).items():
        spans = [(start, end, "on") for start, end in on]
        _lane(f"signal_{number}", _states(spans, "off", a.run.horizon_s))


def _states(
    spans: Sequence[tuple[float, float, str]], otherwise: str, end_s: float
) -> list[tuple[float, str]]:
    """Return the changes of state: the words of every span, and another word between them."""
    changes = {0.0: otherwise}
    for start, end, words in sorted(spans):
        changes[start] = words
        if end < end_s:
            changes[end] = otherwise
    return sorted(changes.items())


def _lane(name: str, rows: Sequence[tuple[float, str]]) -> None:
    if rows:
        rr.send_columns(
            f"lanes/{name}",
            [rr.TimeColumn(TIMELINE, duration=np.array([t for t, _ in rows]))],
            rr.StateChange.columns(state=[words for _, words in rows]),
        )


def _texts(a: Assessment) -> None:
    assert a.run is not None
    rows: list[tuple[float, str, str]] = []
    for event in a.run.events:
        words = event_text(event)
        if words is None:
            continue
        kind, text = words
        where = f"line {event.cause.span.line}  " if event.cause else ""
        said = "TYPE: " if isinstance(event, Printed) else ""
        level = LEVELS.get(kind, "DEBUG")
        rows.append((event.time_s, f"{where}{said}{text}", level))
    if a.judgement is not None and a.judgement.collisions is not None:
        for contact in a.judgement.collisions.contacts:
            rows.append((contact.start_s, f"contact: {contact_sentence(contact)}", "ERROR"))
    rows.sort(key=lambda row: row[0])
    if not rows:
        return
    rr.send_columns(
        "log",
        [rr.TimeColumn(TIMELINE, duration=np.array([row[0] for row in rows]))],
        rr.TextLog.columns(text=[row[1] for row in rows], level=[row[2] for row in rows]),
    )


def _summary(a: Assessment) -> str:
    from vrts.report.first_screen import first_screen

    screen = first_screen(a)
    mark = "" if screen.mark is None else f"**{float(screen.mark):.1f} of 10**, "
    ready = "yes" if screen.ready else "no"
    return f"# {a.title}\n\n{mark}ready for the real robot: {ready}\n\n{screen.cause}\n"


def _transform(X: Pose) -> rr.Transform3D:
    return rr.Transform3D(
        translation=X.translation, mat3x3=np.array(X.rotation, dtype=np.float32).reshape(3, 3)
    )


def _path(name: str) -> str:
    return rr.escape_entity_path_part(name.replace(" ", "_"))


def _srgb(linear: float) -> float:
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
