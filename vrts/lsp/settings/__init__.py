"""Help with scene, task and other TOML files while they are written: keys, values, what they mean.

In: the text of such a file, and a place in it. Out: proposals and explanations, from its schema.
Reads no scene and knows no server: whether a file is right is told by `lsp.runs.scenes`.
"""
