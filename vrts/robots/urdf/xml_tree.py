"""XML as a small tree with line numbers, from files nobody vouches for.

Document types are refused, so no entity can be declared, expanded or fetched; depth and number of
elements are bounded; the text is UTF-8.
"""

from collections.abc import Iterator
from typing import NamedTuple
from xml.parsers import expat

MOST_ELEMENTS = 20_000
MOST_DEPTH = 40


class Element(NamedTuple):
    """An element without its text."""

    tag: str
    attributes: dict[str, str]
    children: "list[Element]"
    line: int  # from 1

    def all(self, tag: str) -> "Iterator[Element]":
        """Yield the children of a tag."""
        return (child for child in self.children if child.tag == tag)

    def first(self, tag: str) -> "Element | None":
        """Return the first child of a tag."""
        return next(self.all(tag), None)


class XmlFault(Exception):  # noqa: N818 -- names what it is
    """A text is not XML that is accepted here."""

    def __init__(self, message: str, line: int) -> None:
        """Say what is wrong and where, from line 1."""
        super().__init__(message)
        self.message = message
        self.line = line


def read_xml(data: bytes) -> Element:
    """Return the root of an XML document.

    Raises:
        XmlFault: It is not well-formed, declares a document type, or is too deep or too large.
    """
    parser = expat.ParserCreate("utf-8")  # whatever the text says of itself
    stack = [Element("", {}, [], 0)]
    count = 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        line = parser.CurrentLineNumber
        if len(stack) > MOST_DEPTH:
            raise XmlFault(f"elements are nested more than {MOST_DEPTH} deep", line)
        if count > MOST_ELEMENTS:
            raise XmlFault(f"more than {MOST_ELEMENTS} elements", line)
        element = Element(tag, attributes, [], line)
        stack[-1].children.append(element)
        stack.append(element)

    def end(_tag: str) -> None:
        stack.pop()

    def document_type(*_: object) -> None:
        raise XmlFault("a document type is declared; it is not needed", parser.CurrentLineNumber)

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.StartDoctypeDeclHandler = document_type
    try:
        parser.Parse(data, True)
    except expat.ExpatError as fault:
        message = expat.errors.messages.get(fault.code, "not well-formed")
        raise XmlFault(f"not XML: {message}", fault.lineno) from fault
    return stack[0].children[0]
