"""JSON as text that is safe wherever it is shown."""

import json
from collections.abc import Mapping

from vrts.report.plain import SERVICE_COMMAND


def json_text(data: Mapping[str, object]) -> str:
    """Return a document, indented; what was foreign in it comes back exactly when it is read.

    The text is ASCII, so that no terminal obeys it and any encoding of stdout can carry it.
    """
    text = json.dumps(data, indent=2, ensure_ascii=True, allow_nan=False)
    return SERVICE_COMMAND.sub(r"\\u0023", text.replace("\x7f", r"\u007f"))
