"""What a certificate proves, in words."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.units import mm
from vrts.check.proof.covered import DEEP, PRESSED
from vrts.check.proof.given import Claims, Meeting, Proven
from vrts.check.proof.tables import beyond_m
from vrts.engine.run import Run
from vrts.engine.storage.origin import Origin, module_digest
from vrts.report.plain import one_line

SHORT = 12  # characters of a hash


class About(NamedTuple):
    """What a certificate is about."""

    name: str  # of its file
    size: int  # [bytes]
    run: Run
    origin: Origin
    scenario: str  # hash


def proof_text(about: About, claims: Claims, proven: Proven) -> str:
    """Return what is proven, of what, and by how much looking."""
    return "\n".join(_lines(about, claims, proven))


def _lines(about: About, claims: Claims, proven: Proven) -> Iterator[str]:
    run = about.run
    yield f"{one_line(about.name)} holds: for every instant from 0 to {run.horizon_s:.3f} s"
    deep, pressed = f"{mm(DEEP):g} mm", f"{mm(PRESSED):g} mm"
    if claims.meetings:
        count = len(claims.meetings)
        yield f"  {'one contact' if count == 1 else f'{count} contacts'}, and no other:"
        yield from (f"    {_contact(meeting)}" for meeting in claims.meetings)
    else:
        yield "  nothing touches anything"
    yield f"  (a contact is deeper than {deep}; pads may press {pressed} into what they hold)"
    if claims.clearance_m is not None:
        assert proven.nearest_m is not None
        yield f"  at least {mm(claims.clearance_m):.2f} mm remain everywhere;"
        yield f"  two points come as near as {mm(proven.nearest_m):.2f} mm"
        if claims.let_go or claims.parted:
            yield "  (fingers about what they grasp, and what is lifted and set down, do not count"
            yield f"  before they were {_beyond(claims)} apart and come nearer again)"
    yield "of:"
    for source in about.origin.programs.sources:
        yield f"  program     {one_line(source.name)}"
    yield f"  compiled    sha256 {module_digest(run.module)[:SHORT]}"
    yield f"  scene       {one_line(run.scene.name)}, sha256 {run.scene.digest[:SHORT]}"
    yield f"  scenario    sha256 {about.scenario[:SHORT]}"
    model = about.origin.scene
    yield f"  controller  {one_line(model.controller)}, sha256 {model.controller_digest[:SHORT]}"
    yield "looked at:"
    yield f"  {proven.rows:,} pairs of pieces, {proven.leaves:,} intervals, boxes for the rest"
    yield f"  the tightest interval holds by {mm(proven.margin_m):.4f} mm; {about.size:,} bytes"


def _beyond(claims: Claims) -> str:
    return f"{mm(beyond_m(claims)):g} mm"


def _contact(meeting: Meeting) -> str:
    first, second, from_s, to_s = meeting
    return f"{one_line(first)} and {one_line(second)}, between {from_s:.3f} and {to_s:.3f} s"
