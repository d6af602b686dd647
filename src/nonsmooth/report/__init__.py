"""The paper recomputed for one oscillator: its figures, its equations and its claims.

Input: an oscillator.  Output: a page, and the figures as files.  `claims` says what is
checked, `intervals` where it holds, `figures` draws, `page` puts it together.
"""
