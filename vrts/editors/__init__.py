"""Highlighting for editors and web pages, made of the vocabulary.

In: the table of words. Out: grammars, lexers, the extension for VS Code.
Knows no run and no protocol.
"""
