"""What other programs read: JSON, SARIF, annotations of GitHub, tables.

In: assessments, runs, diagnostics. Out: text by a published schema.
Knows no terminal.
"""
