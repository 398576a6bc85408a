"""Classes of synthetic students who write programs alone, and some who copy.

Written without sight of what finds likeness: nothing here knows how programs are compared.
"""
