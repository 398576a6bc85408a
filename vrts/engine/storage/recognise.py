"""How a saved run begins, whatever may be wrong with the rest of it."""

MANIFEST = "vrun.json"  # the first member: what the run says about itself
_START = b"PK\x03\x04"  # of a member in a zip
_NAME_AT = 30  # offset of its name


def is_saved_run(data: bytes) -> bool:
    """Return whether bytes begin as a saved run does, sound or not."""
    return data.startswith(_START) and data[_NAME_AT:].startswith(MANIFEST.encode())
