"""What happened, in words for a list."""

from vrts.engine.memory.events import (
    AnalogChanged,
    Answered,
    CommandRefused,
    Event,
    Found,
    Grasped,
    HandCommanded,
    Landed,
    MissedOffCentre,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramProgressed,
    ProgramStarted,
    Prompted,
    Reacted,
    Released,
    SignalChanged,
    SpeedChanged,
    SwitchChanged,
    Toppled,
)
from vrts.report.plain import one_line
from vrts.report.quantities import millimetres


def event_text(event: Event) -> tuple[str, str] | None:
    """Return the kind and the words of an event worth a row; None for the ends of motions."""
    match event:
        case ProgramStarted(program=program, process=process):
            return ("program", f"{'process ' if process else ''}program {program} starts")
        case ProgramEnded(ending=ending, process=process):
            return ("program", f"{'process ' if process else ''}program over: {ending}")
        case ProgramProgressed():
            return None
        case MotionStarted(cause=cause):
            return ("motion", one_line(cause.span.text))
        case MotionEnded():
            return None
        case HandCommanded(action=action):
            return ("hand", f"hand: {action}")
        case Grasped(body=body):
            return ("grasp", f"{body} grasped")
        case MissedOffCentre(body=body):
            return ("fault", f"{body} missed: only one finger meets it")
        case Released(body=body, height_m=height):
            fall = f", to fall {millimetres(height):g} mm" if height > 0 else ""
            return ("grasp", f"{body} released{fall}")
        case Landed(body=body, support=support, also=also):
            return ("grasp", f"{body} stands on {' and '.join((support, *also))}")
        case Toppled(body=body, support=support, also=also):
            return ("fault", f"{body} cannot stand on {' and '.join((support, *also))}")
        case SignalChanged(signal=signal, on=on):
            return ("signal", f"signal {signal} {'on' if on else 'off'}")
        case Printed(text=text):
            return ("output", one_line(text)) if text.strip() else None
        case SwitchChanged(switch=switch, on=on):
            return ("program", f"switch {one_line(switch)} {'on' if on else 'off'}")
        case AnalogChanged(channel=channel, value=value):
            return ("signal", f"analog output {channel} is {value:g}")
        case Prompted():
            return ("output", "the program waits for an answer")
        case Answered(text=text):
            return ("output", f"answer: {one_line(text)}")
        case Reacted(signal=0, program=program):
            return ("signal", f"program {program} reacts to an error")
        case Reacted(signal=signal, program=program):
            return ("signal", f"program {program} reacts to signal {signal}")
        case SpeedChanged(percent=percent):
            return ("program", f"operator's speed {percent:g} %")
        case CommandRefused(words=words):
            return ("fault", f"command refused: {one_line(words)}")
        case Found(diagnostic=diagnostic):
            kind = "fault" if diagnostic.is_error else "note"
            return (kind, one_line(diagnostic.headline))
