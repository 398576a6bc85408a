"""JSON Schemas of the files that people write, asked from the readers of these files.

In: probes, which are files of each kind, and words about their keys. Out: `vrts/schemas`.
`python -m tests.schemas` writes them; a test tells when they are out of date.
"""
