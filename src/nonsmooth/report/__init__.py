"""The paper recomputed for one oscillator: its figures, its equations and its claims.

Input: an oscillator.  Output: a page, and the figures as files.  `claims` and `checks` test the
claims, `intervals` finds the parameters for which they hold, `figures` draws, `page` combines.
"""
