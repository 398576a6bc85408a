"""Bounds of a run that an editor waits for, and what a run says itself within them."""

from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.engine.faults import MOTIONS, STATEMENTS
from vrts.engine.hand.told import CLOSED_ON_NOTHING
from vrts.engine.motion.remarks import without_forecasts
from vrts.engine.run import Run
from vrts.lsp.channel.verification import STOPPED
from vrts.pipeline.setting import Setting
from vrts.scene.model import Limits

_STATEMENTS, _MOTIONS, _SIMULATED_S = 200_000, 5_000, 600.0


def bounded(full: Limits) -> Limits:
    """Return the limits of a run with bounds for an editor."""
    return replace(
        full,
        statements=min(full.statements, _STATEMENTS),
        motions=min(full.motions, _MOTIONS),
        time_s=min(full.time_s, _SIMULATED_S),
    )


def said_by(run: Run, full: Limits, setting: Setting) -> list[Diagnostic]:
    """Return what a run says itself, as far as it is true of a run without our bounds."""
    ours = {STATEMENTS: full.statements > _STATEMENTS, MOTIONS: full.motions > _MOTIONS}
    found: list[Diagnostic] = []
    for d in without_forecasts(run.findings):
        if ours.get(d.rule, False):
            text = f"the verification in the background stops here: {d.headline}"
            help_ = ("`vrts verify` takes the time it needs", *d.help)
            found.append(Diagnostic(STOPPED, Severity.NOTE, text, d.primary, help=help_))
        elif d.rule != CLOSED_ON_NOTHING or setting.task is not None:
            found.append(d)  # where there is no scene there is nothing to grasp
    return found
