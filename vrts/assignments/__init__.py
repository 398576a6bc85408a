"""Assignments: written from templates, checked, copied, and packed for students and staff."""
