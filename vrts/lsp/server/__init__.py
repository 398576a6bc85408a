"""The language server protocol over standard input and output: a thin shell over `vrts.lsp`."""
