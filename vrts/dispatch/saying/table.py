"""Which pin of a controller is which signal of VAL-II: a small file that people edit."""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.base.toml.table import Table as Toml
from vrts.dispatch.saying.cannot import CannotSay
from vrts.pipeline.refused import Refused

TABLE = "io.toml"
HIGHEST_PIN = 61  # of LinuxCNC's digital pins; the two above tell which kinematics holds
HEAVIEST_KG = 100.0  # that a table may say: no arm here carries more
PIN_TWICE = Rule("V871", "linuxcnc-table")


class Payload(NamedTuple):
    """What hangs on the flange."""

    mass_kg: float
    centre_mm: tuple[float, ...]  # of gravity, in the flange's frame


class Table(NamedTuple):
    """Pins by signal."""

    inputs: dict[int, int]  # signal 1001 and above: number of a digital input
    outputs: dict[int, int]  # signal 1 and above: number of a digital output
    hand_open: int  # digital output that opens the hand
    hand_close: int
    payload: Payload | None = None  # where the controller wants to know it, and the user does

    def input(self, signal: int) -> int:
        """Return the pin of an input."""
        return self._pin(self.inputs, signal, "inputs")

    def output(self, signal: int) -> int:
        """Return the pin of an output."""
        return self._pin(self.outputs, signal, "outputs")

    def _pin(self, pins: dict[int, int], signal: int, where: str) -> int:
        if signal not in pins:
            raise CannotSay(f"signal {signal} is not in {TABLE}", f"add it to [{where}]")
        return pins[signal]


def usual(inputs: Iterable[int], outputs: Iterable[int]) -> Table:
    """Return the table of a program for which nobody wrote one: pins in the order of signals."""
    return Table(
        {signal: pin for pin, signal in enumerate(sorted(set(inputs)))},
        {signal: pin for pin, signal in enumerate(sorted(set(outputs)), start=2)},
        hand_open=0,
        hand_close=1,
    )


def table_text(table: Table, kind: str, written: str) -> str:
    """Return the file of a table.

    Args:
        table: The table.
        kind: What the controller calls a pin: `digital pin of LinuxCNC`.
        written: How its numbers are written: `NN of motion.digital-{}-NN`, with `in` or `out`.
    """
    rows = [
        f"# Which {kind} is which signal. Edit it, then export again.",
        "",
        f"[hand]  # {written.format('out')}, of the two valves",
        f"open = {table.hand_open}",
        f"close = {table.hand_close}",
        "",
        f"[inputs]  # signal = {written.format('in')}",
        *(f"{signal} = {pin}" for signal, pin in table.inputs.items()),
        "",
        f"[outputs]  # signal = {written.format('out')}",
        *(f"{signal} = {pin}" for signal, pin in table.outputs.items()),
    ]
    if table.payload is not None:
        centre = ", ".join(f"{part:g}" for part in table.payload.centre_mm)
        rows += ["", "[payload]  # what hangs on the flange, with what the hand holds"]
        rows += [f"mass_kg = {table.payload.mass_kg:g}", f"centre_mm = [{centre}]"]
    return "\n".join(rows) + "\n"


def read_table(source: SourceFile, *, payloads: bool = False) -> Table:
    """Return the table that a file holds.

    Args:
        source: The file.
        payloads: Whether it may say what hangs on the flange.

    Raises:
        Refused: The file has errors.
    """
    top, problems = read_toml(source)
    if top is None:
        raise Refused(problems.in_order())
    hand = top.table("hand", required=True)
    inputs, outputs = top.table("inputs"), top.table("outputs")
    payload = _payload(top) if payloads else None
    top.finish()
    if hand is None:
        raise Refused(problems.in_order())
    used: dict[int, str] = {}

    def pin(table: Toml, key: str, taken: dict[int, str]) -> int:
        value = table.integer(key, minimum=0, maximum=HIGHEST_PIN, required=True)
        if value is None:
            return 0
        if value in taken:
            problems.error(
                PIN_TWICE,
                f"pin {value} stands for `{taken[value]}` and `{key}`",
                table.value_span(key),
            )
        taken[value] = key
        return value

    opens, closes = pin(hand, "open", used), pin(hand, "close", used)
    hand.finish()

    def pins(table: Toml | None, taken: dict[int, str]) -> dict[int, int]:
        found: dict[int, int] = {}
        for key in () if table is None else table.keys:
            if not key.isdigit():
                assert table is not None
                problems.error(PIN_TWICE, f"`{key}` is no number of a signal", table.span_of(key))
                table.integer(key)
                continue
            assert table is not None
            found[int(key)] = pin(table, key, taken)
        return found

    read = Table(pins(inputs, {}), pins(outputs, used), opens, closes, payload)
    if problems.any_error:
        raise Refused(problems.in_order())
    return read


def _payload(top: Toml) -> Payload | None:
    table = top.table("payload")
    if table is None:
        return None
    mass = table.number("mass_kg", minimum=0.0, maximum=HEAVIEST_KG, required=True)
    centre = table.numbers("centre_mm", count=3, required=True)
    table.finish()
    return None if mass is None or centre is None else Payload(mass, centre)
