r"""The derived equations as SymPy objects: show one, check one, put all into a thesis.

An equation has its number in the paper, its sides from the paper's form to the closed form,
and the range of its indices.  Here the closed form of the slip integral C_k, which all of
(5) to (7) are made of, is held against quadrature; and the equations of the C1 series go to
``c1.tex``, to be read in by ``\input{c1}`` in a document that loads ``amsmath``.

Prints::

    (10) velocity at t = 0: Sum(n*omega_0*a[n], (n, 1, N)) = V
    C_3 for t1 = 2, T = 7: 0.290342138566, by quadrature 0.290342138566
    c1.tex: equations 15, 16, 17, 18, 19, 20
"""

from pathlib import Path

import nonsmooth as ns

fourier = ns.equations("hb")
equation = fourier.equation("10")
_, series, value = equation.sides
print(f"({equation.number}) {equation.title}: {series} = {value}")

frequency = next(e for e in fourier.equations if e.title == "frequency")
integral = next(e for e in fourier.equations if e.title == "slip integral C_k")
_, unevaluated, closed = integral.sides
values = {"k": 3, "t1": 2, "T": 7}
numbers = {symbol: values[symbol.name] for symbol in closed.free_symbols}
quadrature = unevaluated.subs(*frequency.sides).subs(numbers).evalf()
value = closed.subs(numbers).evalf()
print(f"C_3 for t1 = 2, T = 7: {value:.12f}, by quadrature {quadrature:.12f}")

c1 = ns.equations("c1")
Path("c1.tex").write_text(c1.latex(), encoding="utf-8")
tags = dict.fromkeys(each.number for each in c1.equations if each.number)
print("c1.tex: equations", ", ".join(tags))
