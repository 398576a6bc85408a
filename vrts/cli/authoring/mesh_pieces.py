"""Pieces of meshes for `vrts scene check`: written, told in words, and drawn."""

import colorsys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import say, write_file
from vrts.pipeline.pieces.in_scene import Asked, Shown, look_at_pieces, make_pieces

if TYPE_CHECKING:
    from vrts.base.diagnostic import Diagnostic
    from vrts.base.source import SourceFile
    from vrts.pipeline.setting import Setting
    from vrts.scene.colors import Color
    from vrts.scene.model import Body, Scene

TOWARDS = (-0.6, 0.5, -0.6)  # view of the picture: onto the side that is away from the robot
GOLDEN = 0.6180339887498949  # turns of the colour wheel from piece to piece


def write_pieces(scene_file: Path, asked: Asked) -> "tuple[Diagnostic, ...]":
    """Write the pieces files that the meshes of a scene need; return what cannot be taken."""
    from vrts.pipeline.files import read_toml_source

    folder = scene_file.parent
    files, found = make_pieces(read_toml_source(scene_file), folder, asked)
    for name, data in files.items():
        place = folder / name
        if place.is_file() and place.read_bytes() == data:
            say(f"{place} is as it was")
            continue
        write_file(place, data)
        say(f"wrote {place}")
    return found


def told_pieces(source: "SourceFile", folder: Path) -> "tuple[list[str], tuple[Diagnostic, ...]]":
    """Return what there is to say of the meshes of a scene, in lines, and what is wrong."""
    shown, found = look_at_pieces(source, folder)
    return [line for each in shown for line in _lines(each)], found


def task_pieces(setting: "Setting", folder: Path) -> "tuple[Diagnostic, ...]":
    """Return what is wrong with the meshes of the task in a folder, proven again."""
    from vrts.pipeline.files import find_scene, read_toml_source

    if setting.task is None or not any(body.kind == "mesh" for body in setting.scene.bodies):
        return ()
    place = find_scene(setting.task.scene, folder)
    return look_at_pieces(read_toml_source(place), place.parent)[1]


def _lines(shown: Shown) -> Iterable[str]:
    pieces, beside = shown.pieces, shown.beside
    corners = sum(len(points) for points in pieces.corners)
    yield (
        f"{shown.name}: `{shown.keys.file}` in {pieces.unit}, {shown.keys.up} up: "
        f"{len(pieces.corners)} convex pieces with {corners} corners"
    )
    if beside is None:
        yield "  the mesh is not here, so the pieces are not compared with it; runs do not need it"
        return
    pieces = beside.pieces
    more = 100.0 * (pieces.pieces_volume / pieces.mesh_volume - 1.0)
    yield (
        f"  the mesh: {pieces.triangles:,} triangles, closed, {pieces.mesh_volume / 1000:,.1f} cm3;"
        f" all pieces together {pieces.pieces_volume / 1000:,.1f} cm3 ({more:+.1f} %, "
        "measured with 20,000 points)"
    )
    if beside.stands_out > 0.0:
        yield f"  the mesh stands out of the pieces by up to {beside.stands_out:.3f} mm"
    else:
        yield (
            "  proven: the pieces hold the whole surface of the mesh, triangle by triangle; "
            "no contact is missed"
        )
    yield (
        f"  proven: the pieces stand out of the mesh by at most {pieces.at_most:.2f} mm "
        f"({pieces.found:.2f} mm found); contacts may be told that much too early"
    )


def drawn_pieces(scene: "Scene") -> bytes:
    """Return a PNG picture of the scene with every piece of a mesh in a colour of its own."""
    import numpy as np

    from vrts.report.picture.camera import fitting
    from vrts.report.picture.still import SIZE, still
    from vrts.scene.outline import corners

    meshes = [body for body in scene.bodies if body.kind == "mesh"]
    points = [body.X_WO.apply(c) for body in meshes for p in body.pieces for c in corners(p)]
    camera = fitting(np.array(points), np.array(TOWARDS), SIZE) if points else None
    bodies = tuple(_painted(body) for body in scene.bodies)
    return still(replace(scene, bodies=bodies), scene.robot.arm.ready, camera=camera)


def _painted(body: "Body") -> "Body":
    if body.kind != "mesh":
        return body
    return replace(body, paint=tuple(_color(n) for n in range(len(body.pieces))))


def _color(number: int) -> "Color":
    hue = (number * GOLDEN) % 1.0
    return colorsys.hls_to_rgb(hue, 0.35 + 0.15 * (number % 2), 0.7)
