"""The section `[controller]` of a scene or a lab: the controller model that runs go by.

A scene names a model. A lab may also say what was fitted from logs of its own controller, with the
hashes of these logs: `vrts validate --fit` writes it.
"""

from dataclasses import replace

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Table
from vrts.controllers.model import FITTED, ControllerModel
from vrts.controllers.models import MODELS, USUAL
from vrts.scene.reading.robot_section import BLEND_TIME, SLOWEST_S

NOT_FITTED = Rule("V425", "not-fitted")

NUMBERS = ("acceleration_s", "blend_s")
SHA256 = 64  # hexadecimal digits


def read_controller(section: Table | None) -> ControllerModel:
    """Return the controller model that a section names, with what was fitted of it.

    What is wrong is reported; the usual model then stands in for the rest of the reading.
    """
    if section is None:
        return USUAL
    name = section.string("model", USUAL.name, choices=MODELS)
    acceleration = section.number("acceleration_s", above=0.0, maximum=SLOWEST_S)
    whole = section.number("blend_s", above=0.0, maximum=SLOWEST_S)
    logs = section.strings("fitted_from")
    section.finish()
    base = MODELS.get(name, USUAL)
    numbers = [key for key in NUMBERS if key in section]
    if not numbers and "fitted_from" not in section:
        return base
    if not numbers or not logs or any(not _is_hash(log) for log in logs):
        section.problems.error(
            NOT_FITTED,
            "numbers of a controller come with the logs that they were fitted from",
            section.span_of(numbers[0]) if numbers else section.span_of("fitted_from"),
            help=("`vrts validate LOG PROGRAM --fit --lab-out FILE` writes both",),
        )
        return base
    if whole is not None and acceleration is not None and whole < acceleration:
        section.problems.error(
            BLEND_TIME,
            "corners are shorter than the arm takes to stop",
            section.value_span("blend_s"),
            f"a corner takes {whole:g} s, stopping {acceleration:g} s",
            help=("give a `blend_s` that is at least `acceleration_s`",),
            data={"blend_s": whole, "acceleration_s": acceleration},
        )
    return replace(
        base,
        name=base.name + FITTED,
        title=f"{base.title}, with the pace fitted from logs",
        pace=base.pace._replace(acceleration_s=acceleration),
        corners=base.corners._replace(whole_s=whole),
        fitted_from=tuple(logs),
    )


def _is_hash(text: str) -> bool:
    return len(text) == SHA256 and set(text) <= set("0123456789abcdef")
