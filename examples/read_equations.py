r"""The derived equations as SymPy objects: show one, check one, put all into a thesis.

An equation has its number in the paper, its sides from the paper's form to the closed form,
and the range of its indices.  Here the closed form of the integral of a cosine over slip,
which (5) to (7) are made of, is held against quadrature; and the equations of Section 3.3 go
to ``c1.tex``, to be read in by ``\input{c1}`` in a document that loads ``amsmath``.

Prints::

    (5) residual, orthogonal to the constant:
      <R(t), 1> = -F_N*mu_k*C_slip[0] + K*a0*C_slip[0]/2 +
      Sum(K*C_slip[n]*b[n] + K*S_slip[n]*a[n], (n, 1, N))
    C_slip[3] for t1 = 2, T = 7: 0.290342138566, by quadrature 0.290342138566
    c1.tex: 30 equations
"""

from pathlib import Path

import sympy as sp

import nonsmooth as ns

fourier = ns.equations("hb")
equation = fourier.equation("5")
tested, closed, _ = equation.sides
print(f"({equation.number}) {equation.title}:")
print(f"  {tested} = {closed}")

integral = next(each for each in fourier.equations if isinstance(each.sides[1], sp.Integral))
_, unevaluated, closed = integral.sides
values = {"l": 3, "omega_0": 2 * sp.pi / 7, "t1": 2, "T": 7}
symbols = unevaluated.free_symbols | closed.free_symbols
numbers = {symbol: values[symbol.name] for symbol in symbols}
quadrature, value = unevaluated.subs(numbers).n(), closed.subs(numbers).n()
print(f"C_slip[3] for t1 = 2, T = 7: {value:.12f}, by quadrature {quadrature:.12f}")

c1 = ns.equations("c1")
Path("c1.tex").write_text(c1.latex(), encoding="utf-8")
print(f"c1.tex: {len(c1.equations)} equations")
