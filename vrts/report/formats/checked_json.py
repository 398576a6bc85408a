"""What was found in several files, as one document of JSON."""

from collections.abc import Sequence

from vrts.report.formats.checked import Checked
from vrts.report.formats.diagnostic_json import Json, diagnostic_json


def checked_json(checked: Sequence[Checked]) -> Json:
    """Return the document; the files are in the order given."""
    return {
        "schema": "vrts.diagnostics/1",
        "compiles": all(file.compiles for file in checked),
        "files": [{"file": file.name, "compiles": file.compiles} for file in checked],
        "diagnostics": [
            {"file": file.name, **diagnostic_json(d)} for file in checked for d in file.diagnostics
        ],
    }
