"""Types and values of the language once every spelling question is answered."""

from enum import Enum
from typing import TypeAlias

from vrts.base.pose import Pose


class Type(Enum):
    """Static type of a variable or expression."""

    REAL = "real"  # single precision; also every logical value (TRUE is -1)
    STRING = "string"
    POSE = "pose"  # VAL's transformation
    JOINTS = "joints"  # VAL's precision point
    DYNAMIC = "dynamic"  # a formal whose type is known only at run time

    __hash__ = object.__hash__  # each name is looked up by its type: that of Enum is slow


Joints: TypeAlias = tuple[float, float, float, float, float, float]
"""A precision point: six joint positions in rad."""

Value: TypeAlias = float | str | Pose | Joints
"""A value in memory. Reals are rounded to single precision; poses and joints are double."""


def type_of_value(value: Value) -> Type:
    """Return the type of a value."""
    if isinstance(value, float):
        return Type.REAL
    if isinstance(value, str):
        return Type.STRING
    if isinstance(value, Pose):
        return Type.POSE
    return Type.JOINTS
