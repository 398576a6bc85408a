"""What STORE writes for a program."""

from vrts.lang.compiler import Compilation
from vrts.lang.writing.store import store_text


def store(compilation: Compilation, *, exact: bool = False) -> str:
    """Return what STORE writes for a compilation that succeeded."""
    module, source = compilation.module, compilation.source
    assert module is not None
    assert source is not None
    return store_text(source, module, compilation.dialect, exact=exact)
