"""The document of the class, as published: `vrts schema class`."""

from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.row import class_to_bytes


def class_json(given: Given, options: Options) -> Product:
    """Return the document."""
    del options
    whole = given.whole
    return Product([("class.json", class_to_bytes(whole, judged=whole.unsafe is not None))])
