"""Whether parameters are what the protocol says, before anything is done with them."""

import re
import types as plain
from collections.abc import Mapping, Sequence
from enum import Enum
from functools import cache
from typing import Any, Literal, NamedTuple, Union, cast, get_args, get_origin
from urllib.parse import unquote, urlsplit

import attrs
from lsprotocol import types
from lsprotocol.validators import uinteger_validator

MOST_NUMBER = 2**31 - 1
_WORDS = {str: "a text", int: "a whole number", float: "a number", bool: "true or false"}


def misfit(value: Any, wanted: Any, at: str = "") -> str:
    """Return what is wrong with a value of JSON, as a sentence; nothing where it fits.

    Args:
        value: As JSON has it.
        wanted: A type of the protocol.
        at: Where the value stands.
    """
    if wanted is Any or wanted is types.LSPObject:
        return ""
    if attrs.has(wanted):
        return _of_object(value, wanted, at)
    origin, inner = get_origin(wanted), get_args(wanted)
    if origin in (Union, plain.UnionType):
        return _of_several(value, inner, at)
    if origin is Literal:
        return "" if value in inner else f"{at} is not `{inner[0]}`"
    if origin is tuple or (isinstance(origin, type) and issubclass(origin, Sequence)):
        if not isinstance(value, list):
            return f"{at} is {_told(value)}, not a list"
        several = cast("list[Any]", value)
        each = (misfit(one, inner[0], f"{at}[{n}]") for n, one in enumerate(several))
        return next((why for why in each if why), "")
    if isinstance(origin, type) and issubclass(origin, Mapping):
        if not isinstance(value, dict):
            return f"{at} is {_told(value)}, not an object"
        named = cast("dict[str, Any]", value)
        each = (misfit(one, inner[1], f"{at}.{name}") for name, one in named.items())
        return next((why for why in each if why), "")
    if isinstance(wanted, type) and issubclass(wanted, Enum):
        base = str if issubclass(wanted, str) else int
        return misfit(value, base, at)
    return _of_plain(value, wanted, at)


def _of_object(value: Any, wanted: Any, at: str) -> str:
    if not isinstance(value, dict):
        return f"{at or 'what is asked'} is {_told(value)}, not an object"
    value = cast("dict[str, Any]", value)
    for field in _fields(wanted):
        where = f"{at}.{field.name}" if at else field.name
        if field.name not in value:
            if field.required:
                return f"{where} is missing"
            continue
        inner = value[field.name]
        why = misfit(inner, field.wanted, where)
        if why:
            return why
        if isinstance(inner, str) and field.name.lower().endswith(("uri", "path")) and _odd(inner):
            return f"{where} is no address of a file or buffer"
        if field.counts and isinstance(inner, int) and inner < 0:
            return f"{where} is {inner}, and counts from 0"
    if wanted is types.Range and _place(value["start"]) > _place(value["end"]):
        return f"{at} ends before it starts"
    return ""


def _odd(address: str) -> bool:
    """Return whether no system can have such an address: broken, or with letters that none has."""
    try:
        urlsplit(address)
        plain = unquote(address, errors="strict")
        plain.encode("utf-8")
    except ValueError:
        return True
    return "\0" in plain


def _place(position: dict[str, Any]) -> tuple[int, int]:
    return position["line"], position["character"]


def _of_several(value: Any, wanted: tuple[Any, ...], at: str) -> str:
    if value is None and type(None) in wanted:
        return ""
    reasons = [misfit(value, one, at) for one in wanted if one is not type(None)]
    return "" if "" in reasons else reasons[0]


def _of_plain(value: Any, wanted: Any, at: str) -> str:
    if wanted is type(None):
        return "" if value is None else f"{at} is {_told(value)}, not null"
    if wanted is int:
        if isinstance(value, bool) or not isinstance(value, int):
            return f"{at} is {_told(value)}, not a whole number"
        if abs(value) > MOST_NUMBER:
            return f"{at} is too large a number"
        return ""
    if wanted is float:
        number = isinstance(value, int | float) and not isinstance(value, bool)
        return "" if number else f"{at} is {_told(value)}, not a number"
    return "" if isinstance(value, wanted) else f"{at} is {_told(value)}, not {_WORDS[wanted]}"


def _told(value: Any) -> str:
    if value is None:
        return "null"
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        return "a list"
    return _WORDS[type(value)]


class _Field(NamedTuple):
    name: str  # as JSON has it
    wanted: Any  # its type
    required: bool
    counts: bool  # from 0


@cache
def _fields(of: Any) -> tuple[_Field, ...]:
    return tuple(
        _Field(
            re.sub(r"_(\w)", lambda found: found[1].upper(), field.name.strip("_")),
            field.type,
            field.default is attrs.NOTHING,
            getattr(field.validator, "validator", field.validator) is uinteger_validator,
        )
        for field in attrs.fields(of)
    )
