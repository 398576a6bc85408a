"""Many posts beside a straight way of the hand, each equally near."""

from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

PROGRAM = """.PROGRAM main
 SPEED 50 ALWAYS
 MOVE a
 MOVES b
 MOVES a
.END
.LOCATIONS
a 800 -520 -200 90 90 0
b 800 720 -200 90 90 0
.END
"""
TABLE = """title = "posts"
[robot]
name = "puma761"
[objects.table]
kind = "table"
at_mm = [900, 0]
size_mm = [900, 1900]
top_z_mm = -700
"""
FAR = 60.0  # [mm] from the middle of the way to the faces of the posts


def scene_of(beside: float, count: int) -> Scene:
    """Return a scene whose posts begin so many millimetres beside the middle of the way."""
    text = TABLE
    for k in range(count):
        text += f'[objects.post{k}]\nkind = "box"\non = "table"\nsize_mm = [20, 20, 500]\n'
        text += f"at_mm = [{800 + beside + 10:.4f}, {-350 + 50 * k}]\n"
    scene, problems = read_scene(SourceFile("scene.toml", text))
    assert scene is not None, [problem.headline for problem in problems]
    return scene


def run_in(scene: Scene) -> Run:
    """Return the run of the program."""
    module = compile_source(SourceFile("main.v2", PROGRAM), Options(DIALECTS["val2"])).module
    assert module is not None
    return execute(module, scene)


def passing(gap_mm: float, count: int = 20) -> Run:
    """Return a run whose hand passes posts at a distance."""
    far = run_in(scene_of(FAR, count))
    report = check_collisions(far.scene, far, near_miss=0.2)
    assert report.clearance is not None
    beside = FAR - 1e3 * report.clearance.distance_m
    return run_in(scene_of(beside + gap_mm, count))
