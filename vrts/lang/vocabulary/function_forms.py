"""How functions are written, with a word for each argument: `FRAME(on_x1, on_x2, on_y, origin)`."""

from vrts.lang.vocabulary.functions import Signature

_ARGUMENTS = {
    "atan2": "y, x",
    "cos": "angle",
    "sin": "angle",
    "tan": "angle",
    "max": "a, b",
    "min": "a, b",
    "outside": "low, x, high",
    "distance": "one, other",
    "trans": "x, y, z, o, a, t",
    "frame": "on_x1, on_x2, on_y, origin",
    "shift": "location BY dx, dy, dz",
    "scale": "location BY factor",
    "rx": "angle",
    "ry": "angle",
    "rz": "angle",
    "identical": "one, other",
    "#ppoint": "j1, j2, j3, j4, j5, j6",
    "sig": "signal",
    "bits": "first, count",
    "timer": "number",
    "speed": "which",
    "adc": "channel",
    "pendant": "key",
    "chr": "code",
    "$chr": "code",
    "$mid": "$text, first, count",
    "pos": "$text, $part",
    "$encode": "x",
    "$decode": "$text, $separators, 0",
}
_BY_TYPE = {"r": "x", "s": "$text", "$": "$text", "p": "location", "l": "location", "v": "variable"}


def argument_names(signature: Signature) -> tuple[str, ...]:
    """Return a word for each argument that a function may have; `...` where it repeats."""
    listed = _ARGUMENTS.get(signature.name, "").replace(" BY ", ", ").split(", ")
    told = [name for name in listed if name]
    found: list[str] = []
    for number, written in enumerate(signature.parameters):
        by_type = _BY_TYPE.get(written[0], "x")
        name = told[number] if number < len(told) else told[-1] if told else by_type
        found.append(f"{name}..." if written.endswith("*") else name)
    return tuple(found)


def form_of(signature: Signature) -> str:
    """Return a function as it is written, its name in upper case."""
    arguments = _ARGUMENTS.get(signature.name)
    if arguments is None:
        wanted = signature.parameters[: max(signature.required, 1)]
        arguments = ", ".join(_BY_TYPE.get(parameter[0], "x") for parameter in wanted)
    return f"{signature.name.upper()}({arguments})"
