"""What was found, written for people and programs.

In: assessments, runs, diagnostics. Out: text, JSON, HTML, pictures, recordings.
Reports decide nothing.
"""
