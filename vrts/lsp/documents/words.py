"""Words of the language as help shows them."""

from vrts.ir.values import Type
from vrts.lang.vocabulary.function_forms import argument_names
from vrts.lang.vocabulary.functions import Signature
from vrts.lang.vocabulary.word import Word

_PARAMETERS = {
    "r": "number",
    "s": "string",
    "p": "location",
    "l": "location",
    "v": "variable",
    "$": "$string",
    "f": "value",
    "n": "name",
}
_RESULTS = {
    Type.REAL: "a number",
    Type.STRING: "a string",
    Type.POSE: "a location",
    Type.JOINTS: "a precision point",
}


def parameters_of(function: Signature) -> tuple[str, ...]:
    """Return what a function takes, one word an argument."""
    return tuple(_parameter(written) for written in function.parameters)


def function_usage(function: Signature) -> str:
    """Return how a function is written."""
    given = parameters_of(function)
    if not given:
        return function.name.upper()
    by = function.by
    if by is not None:
        listed = ", ".join(given[:by]) + " BY " + ", ".join(given[by:])
    else:
        listed = ", ".join(given)
    return f"{function.name.upper()}({listed})"


def named_usage(function: Signature) -> str:
    """Return how a function is written, with a name for each argument."""
    given = argument_names(function)
    if not given:
        return function.name.upper()
    by = function.by or 0
    listed = ", ".join(given[by:])
    if by:
        listed = ", ".join(given[:by]) + " BY " + listed
    return f"{function.name.upper()}({listed})"


def function_help(function: Signature) -> str:
    """Return what a function yields."""
    return f"{function.about}; {_RESULTS.get(function.result, 'a value')}"


def instruction_help(word: Word) -> str:
    """Return what an instruction does, and what it waits for."""
    rows = [word.about or word.text]
    if word.means and word.means != word.text:
        rows.append(f"Another spelling of {word.means}.")
    if word.breaks:
        rows.append("Waits until the arm stands still.")
    if word.robot:
        rows.append("Needs the robot: not for process control programs.")
    if word.opaque:
        rows.append("Known, and not carried out by the simulator.")
    return "\n\n".join(rows)


def _parameter(written: str) -> str:
    word = _PARAMETERS.get(written[0], "value")
    if written.endswith("*"):
        return f"{word}..."
    return f"[{word}]" if written.endswith("?") else word
