"""The language server: what an editor shows of programs while they are written."""
