"""What comes from outside within a tick: inputs, sensors, faults of the scenario."""

from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.ending import fail
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import SignalChanged, SwitchChanged
from vrts.engine.memory.records import INSTANT
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.scene.model import FaultKind


def bring_faults_about(machine: Machine, now: float) -> None:
    """Let the faults of the scenario happen that are due."""
    faults, system = machine.scenario.faults, machine.system
    while machine.faults_done < len(faults) and faults[machine.faults_done].time_s <= now + INSTANT:
        fault = faults[machine.faults_done]
        machine.faults_done += 1
        match fault.kind:
            case FaultKind.INPUT_STUCK:
                if system.signals.stick(fault.signal, on=fault.on):
                    system.events.append(SignalChanged(now, fault.signal, fault.on, None))
            case FaultKind.GRIPPER_SLIPS:
                system.hand.let_slip(now, None, system.events)
            case FaultKind.PART_MISSING:
                system.hand.miss()
            case FaultKind.EMERGENCY_STOP:
                _emergency_stop(machine, now)


def process_is_first(machine: Machine, now: float) -> bool:
    """Return whether the scenario gives the process control program the first turn of a tick."""
    times, first = machine.scenario.process_first, False
    while machine.turns_done < len(times) and times[machine.turns_done] <= now + INSTANT:
        machine.turns_done += 1
        first = True
    return first


def _emergency_stop(machine: Machine, now: float) -> None:
    system = machine.system
    system.planner.brake(now)
    system.hand.path_changed(now)
    system.powered = False
    system.switches["POWER"] = False
    system.events.append(SwitchChanged(now, "POWER", False, None))
    if machine.robot.running:
        fault = RuntimeFault(
            RuntimeErrorKind.ROBOT_POWER_OFF, "the emergency stop was pressed", None
        )
        fail(machine, machine.robot, fault)


def sample(machine: Machine, now: float) -> None:
    """Set the inputs as the scenario, timers and sensors say."""
    system = machine.system
    changed = system.signals.sample(now)
    while system.scheduled and system.scheduled[0][0] <= now + INSTANT:
        _, number, state = system.scheduled.pop(0)
        if system.signals.turn(number, on=state):
            changed.append((number, state))
    changed += machine.sensing.sample(system, now)
    for signal, on in changed:
        system.events.append(SignalChanged(now, signal, on, None))
