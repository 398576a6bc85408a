"""`vrts scene`."""

from pathlib import Path

import click

from vrts.cli.console import color_option, guarded, out, say, write_file

EPILOG = """\b
Examples:
  vrts scene list
  vrts scene show cans-on-bases
  vrts scene show cans-on-bases --svg map.svg
"""


@click.group(name="scene", epilog=EPILOG)
def command() -> None:
    """List the scenes, or show where things are in one."""


@command.command(name="list")
@guarded
def list_scenes() -> None:
    """List the scenes that come with vrts."""
    from vrts.pipeline import load_scene, scene_names

    for name in scene_names():
        out(f"{name:<20} {load_scene(name).scene.title}")


@command.command(name="show", epilog=EPILOG)
@click.argument("name")
@click.option("--svg", type=click.Path(path_type=Path), help="Write a drawing, top and side view.")
@color_option
@guarded
def show(name: str, svg: Path | None, color: str) -> None:
    """Print every object of scene NAME, and its locations ready to paste into a program."""
    from vrts.pipeline import load_scene
    from vrts.report.scene_text import scene_text

    scene = load_scene(name).scene
    out(scene_text(scene))
    if svg is not None:
        from vrts.report.scene_drawing import scene_svg

        write_file(svg, scene_svg(scene).encode())
        say(f"wrote {svg}")
