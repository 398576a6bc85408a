"""Commands that editors call, or that set editors up: `lsp`, `dap`, `editor`.

In: standard input, or the name of an editor. Out: a server on standard output, or a set-up.
Knows nothing of what an editor is told: that is in `lsp` and `debug`.
"""
