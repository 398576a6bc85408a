"""By what a step came to be executed: a CALL, a reaction."""

from collections.abc import Iterator

from vrts.why.chain import Link
from vrts.why.slicing.executed import Executed, Steps


def reacted(steps: Steps, step: Executed) -> Iterator[Link]:
    """Yield the reaction in which a step was executed, if in one."""
    activation = step.activation
    while activation is not None and activation.called_from is not None:
        entered = steps.entered(activation)
        if entered is None or steps.calls(entered):
            activation = activation.caller
            continue
        program = steps.history.code.programs[activation.program].name
        time_s = steps.time_of(entered)
        yield Link(time_s, entered.cause.span, f"a reaction called `{program}` after this step")
        return


def called(steps: Steps, step: Executed) -> Link | None:
    """Return the CALL in which a step was executed."""
    entered = steps.entered(step.activation)
    if entered is None or not steps.calls(entered):
        return None
    return Link(steps.time_of(entered), entered.cause.span, "it is called here", minor=True)
