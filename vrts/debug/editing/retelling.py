"""What a run tells of places in an old text, told of the same places in a new one."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar, cast

from vrts.base.source import Span
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause

T = TypeVar("T")


class Retelling:
    """Values of a run with every place in the old text replaced."""

    def __init__(self, spans: Mapping[Span, Span], causes: Mapping[Cause, Cause]) -> None:
        """Take where places and steps of the old text are in the new one."""
        self._spans, self._causes = spans, causes

    def of(self, value: T) -> T:
        """Return a value of plain parts with its places in the new text."""
        return cast("T", self._of(value))

    def _of(self, value: Any) -> Any:
        if value is None or isinstance(value, float | int | str):
            return value
        if isinstance(value, Cause):
            return self._causes.get(value, value)
        if isinstance(value, Span):
            return self._spans.get(value, value)
        if isinstance(value, tuple):
            known = cast("tuple[Any, ...]", value)
            parts = [self._of(part) for part in known]
            if all(a is b for a, b in zip(parts, known, strict=True)):
                return known
            kind = cast("Any", type(known))
            return kind(*parts) if hasattr(kind, "_fields") else tuple(parts)
        if isinstance(value, list):
            return [self._of(part) for part in cast("list[Any]", value)]
        if isinstance(value, RuntimeFault):
            return self._fault(value)
        if is_dataclass(value) and not isinstance(value, type):
            return self._record(value)
        return value

    def _record(self, value: Any) -> Any:
        changed: dict[str, Any] = {}
        for field in fields(value):
            before = getattr(value, field.name)
            after = self._of(before)
            if after is not before:
                changed[field.name] = after
        return replace(value, **changed) if changed else value

    def _fault(self, fault: RuntimeFault) -> RuntimeFault:
        return RuntimeFault(
            fault.kind,
            fault.headline,
            self._of(fault.span),
            rule=fault.rule,
            label=fault.label,
            notes=fault.notes,
            help=fault.help,
            joint=fault.joint,
            data=fault.data,
        )
