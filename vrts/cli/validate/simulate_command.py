"""`vrts validate simulate`."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from vrts.cli.shared.console import STDOUT, fail, guarded, say, write_file
from vrts.cli.shared.options import Language, color_option, language_options, overwrite_option
from vrts.cli.validate.shared import run_of, setting_options
from vrts.pipeline.where import Where

Command = TypeVar("Command", bound=Callable[..., Any])

EPILOG = """\b
Examples:
  vrts validate simulate path.v2 -o robot.csv
  vrts validate simulate path.v2 -o robot.csv --lag-ms 12 --base-mm 0.6 0.8 0 --seed 7
  vrts validate simulate path.v2 --scene cans-on-bases --lab true.toml -o robot.csv
  vrts validate simulate path.v2 -o robot.csv --zero-deg 0 0 0.5 0 0 0 --speeds-percent 92
"""
LARGEST = 1000.0


def _several(name: str, count: int, words: str) -> Callable[[Command], Command]:
    """Return an option that takes several numbers."""
    return click.option(
        name,
        type=click.FloatRange(-LARGEST, LARGEST),
        nargs=count,
        default=(0.0,) * count,
        help=words,
    )


@click.command(name="simulate", epilog=EPILOG)
@click.argument("program")
@click.option("-o", "--output", default="-", help="The log to write; `-` is stdout.")
@click.option(
    "--lag-ms",
    type=click.FloatRange(0.0, LARGEST),
    default=20.0,
    show_default=True,
    help="How late every servo is.",
)
@click.option(
    "--encoder-deg",
    type=click.FloatRange(0.0, 10.0),
    default=0.005,
    show_default=True,
    help="The step of every encoder.",
)
@click.option(
    "--noise-deg",
    type=click.FloatRange(0.0, 10.0),
    default=0.01,
    show_default=True,
    help="Noise of every joint, one standard deviation.",
)
@click.option(
    "--base-mm",
    type=click.FloatRange(-LARGEST, LARGEST),
    nargs=3,
    default=(0.6, 0.8, 0.0),
    show_default=True,
    help="How far the base is out of place: X Y Z.",
)
@click.option(
    "--base-turn-deg",
    type=click.FloatRange(-45.0, 45.0),
    default=0.0,
    show_default=True,
    help="How far the base is turned about the vertical.",
)
@_several("--zero-deg", 6, "How far each joint is off; its encoder shows it.")
@_several("--link-mm", 4, "How much longer a2 a3 d2 d4 of the arm are than in the scene.")
@_several("--counted-link-mm", 4, "The same for the lengths that the controller counts with.")
@_several("--tool-mm", 3, "How far the tool is off: X Y Z.")
@click.option(
    "--speeds-percent",
    type=click.FloatRange(10.0, LARGEST),
    default=100.0,
    show_default=True,
    help="All speeds, in percent of what the scene says.",
)
@click.option(
    "--rate-percent",
    type=click.FloatRange(-50.0, 50.0),
    default=0.0,
    help="How much too fast its clock is.",
)
@click.option("--clock-s", type=float, default=0.0, help="What its clock shows at the start.")
@click.option(
    "--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of the noise."
)
@overwrite_option("Replace the file if it exists already.")
@setting_options
@language_options
@color_option
@guarded
def command(
    program: str,
    output: str,
    lag_ms: float,
    encoder_deg: float,
    noise_deg: float,
    base_mm: tuple[float, float, float],
    base_turn_deg: float,
    zero_deg: tuple[float, ...],
    link_mm: tuple[float, ...],
    counted_link_mm: tuple[float, ...],
    tool_mm: tuple[float, float, float],
    speeds_percent: float,
    rate_percent: float,
    clock_s: float,
    seed: int,
    overwrite: bool,
    where: Where,
    entry: str | None,
    language: Language,
    color: str,
) -> None:
    """Write the log that a robot with errors would make of PROGRAM. It is synthetic and says so.

    It has a row every 28 ms: set points joined by straight lines, a servo that lags, encoders with
    steps, noise, a base that is a little out of place. The same seed gives the same bytes. With
    --lab the robot has other speeds than the scene says: something for --fit or --identify to find.
    """
    from vrts.validate.synthetic import Imperfect, synthetic_log

    if output != STDOUT and Path(output).exists() and not overwrite:
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    run, name = run_of(program, where, entry, language, color)
    robot = Imperfect(
        lag_ms / 1e3,
        encoder_deg,
        noise_deg,
        base_mm,
        base_turn_deg,
        clock_s,
        seed,
        zero_deg,
        link_mm,
        counted_link_mm,
        tool_mm,
        speeds_percent,
        rate_percent,
    )
    text = "".join(synthetic_log(run, robot, Path(name).name))
    write_file(Path(output), text.encode())
    if output != STDOUT:
        say(f"wrote {output}")
