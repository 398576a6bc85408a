"""Highlighting for editors and web pages, made of the vocabulary."""
