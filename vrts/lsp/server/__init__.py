"""The language server protocol over standard input and output: a thin shell over `vrts.lsp`.

In: requests of a client. Out: responses and notifications. The only door to pygls and lsprotocol.
Answers nothing itself.
"""
