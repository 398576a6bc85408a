"""What the names of an expression stand for: variables of the controller, or of a call."""

from collections.abc import Sequence
from typing import TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from vrts.debug.conditions.block import Block, Histories, Lanes, Source
from vrts.debug.conditions.columns import Regimes
from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run

Kind: TypeAlias = "type | frozenset[type] | None"
"""Class of a scalar's value, classes of an array's elements; None: there is no such name."""


class Names:
    """The names of one expression, in one run."""

    def __init__(self, run: Run, histories: Histories, names: tuple[str, ...]) -> None:
        """Take all words of the expression; those that are no names stand for nothing."""
        self._run, self._histories, self.names = run, histories, names
        bound = {item.name: item for item in run.history.memory.bound}
        self._globals = [bound.get(name) for name in names]
        self._slots: dict[int, list[tuple[int, int]]] = {}  # name and slot, by program

    def at(self, activation: Activation | None) -> Sequence[Bound | None]:
        """Return what the names stand for, beside them: what is local hides what is global."""
        slots = [] if activation is None else self._slots_of(activation)
        if not slots or activation is None:
            return self._globals
        found = list(self._globals)
        for k, slot in slots:
            found[k] = activation.slots[slot]
        return found

    def _slots_of(self, activation: Activation) -> list[tuple[int, int]]:
        """Return which names are local to a program, each with its slot."""
        slots = self._slots.get(activation.program)
        if slots is None:
            program = self._run.history.code.programs[activation.program]
            listed = [slot.name for slot in (*program.formals, *program.autos)]
            slots = [(k, listed.index(name)) for k, name in enumerate(self.names) if name in listed]
            self._slots[activation.program] = slots
        return slots

    def at_all(self, activations: Sequence[Activation | None]) -> list[Source]:
        """Return what the names stand for in calls of one program."""
        found: list[Source] = list(self._globals)
        first = activations[0]
        for k, slot in [] if first is None else self._slots_of(first):
            bound = [a.slots[slot] for a in activations if a is not None]
            found[k] = bound[0] if all(b is bound[0] for b in bound) else bound
        return found

    def by_kinds(self, block: Block) -> list[tuple[tuple[Kind, ...], Lanes]]:
        """Return the instants of a block, apart by what the names stand for."""
        groups: list[tuple[tuple[Kind, ...], Lanes]] = [((), np.arange(block.count))]
        for source in block.sources:
            codes, kinds = self._codes(source, block)
            if codes is None:
                groups = [((*known, kinds[0]), lanes) for known, lanes in groups]
                continue
            parted: list[tuple[tuple[Kind, ...], Lanes]] = []
            for known, lanes in groups:
                inside = codes[lanes]
                for code, kind in enumerate(kinds):
                    those = lanes[inside == code]
                    if len(those):
                        parted.append(((*known, kind), those))
            groups = parted
        return groups

    def _codes(
        self, source: Source, block: Block
    ) -> tuple[NDArray[np.uint8] | None, Sequence[Kind]]:
        """Return which of some kinds a name stands for at each instant; None: always the first."""
        if source is None:
            return None, (None,)
        if isinstance(source, Cell):
            told = self._histories.of(source)
            return told.codes[told.places(block.finished)], told.kinds
        if isinstance(source, Array):
            regimes = self._histories.regimes_of(source)
            if regimes is not None:
                return regimes.codes(block.finished), [Regimes.kind(code) for code in range(4)]
        bounds = source if isinstance(source, list) else [source] * block.count
        listed = [
            kind_of(content_of(bound, finished))
            for bound, finished in zip(bounds, block.finished.tolist(), strict=True)
        ]
        kinds = list(dict.fromkeys(listed))
        number = {kind: k for k, kind in enumerate(kinds)}
        return np.array([number[kind] for kind in listed], np.uint8), kinds


def content_of(source: Bound | None, finished: int) -> object:
    """Return the value of a scalar after so many statements, the classes of those of an array."""
    if source.__class__ is Cell:
        return source.at(finished)  # type: ignore[union-attr]
    if source is None:
        return None
    elements = cast("Array", source).elements.values()
    return frozenset(cell.at(finished).__class__ for cell in elements)


def kind_of(content: object) -> Kind:
    """Return what an expression is compiled for."""
    if content is None or content.__class__ is frozenset:
        return cast("Kind", content)
    return content.__class__
