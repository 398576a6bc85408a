"""Tables about a class: the one that teachers edit, and lists that platforms export.

In: text of tables of any spreadsheet. Out: rows, and where a cell cannot be meant so.
Looks into no program.
"""
