"""Motions are planned when they are given: what is left to do is to note when they show."""

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Found, MotionEnded, MotionStarted
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.remarks import worded


def note_motions(machine: Machine, until_s: float) -> None:
    """Note the motions that begin and end up to a time [s]."""
    planner, events = machine.system.planner, machine.system.events
    committed = len(planner.given.motions) - (planner.pending is not None)
    while machine.arrived < committed:
        motion = planner.given.motions[machine.arrived]
        if machine.moved == machine.arrived:
            start = planner.scale.time(motion.start_s)
            if start > until_s + INSTANT:
                return
            events.append(MotionStarted(start, machine.moved, motion.cause))
            for remark in planner.remarks.pop(machine.moved, ()):
                finding = worded(remark, motion.cause.span)
                events.append(Found(start, finding, motion.cause))
            machine.moved += 1
        finish = planner.scale.time(motion.end_s)
        open_end = machine.arrived == committed - 1 and planner.pending is not None
        if finish > until_s + INSTANT or open_end:
            return
        events.append(MotionEnded(finish, machine.arrived, motion.cause))
        machine.arrived += 1
