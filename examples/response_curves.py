"""Response curves with their unstable parts: a stop, a play, a spring behind a gap, friction.

The amplitude over the frequency of the force, stable orbits solid, unstable ones dashed; folds,
flips, grazings and the beginnings of a rest are located to rounding and marked.  The picture
goes to ``responses.png``.

Prints::

    impact
      flip 1.014457636784
      flip 1.094976446193
      fold 1.933838782226
      grazing 1.732050807569
    backlash
      branch-point 0.369137106599
      fold 0.816874192231
      fold 0.541172577515
      grazing 0.543177377818
    clearance
      grazing 0.843867938011
      fold 1.234899059684
      fold 1.130048749737
      grazing 1.130436598486
    dry-friction
      sticking 0.114379207474
      sticking 0.207334408814
      sticking 0.535755336593
"""

import matplotlib.pyplot as plt

import nonsmooth as ns

contact = {"force": 0.3, "damping": 0.1, "gap": 1.0}
responses = {
    "impact": ({"damping": 0.0, "restitution": 0.8, "gap": 0.5}, (0.95, 2.2)),
    "backlash": (contact | {"frequency": 0.7}, (0.3, 1.0)),
    "clearance": (contact | {"frequency": 1.0}, (0.3, 2.0)),
    "dry-friction": ({"damping": 0.0, "mu_s": 0.4, "mu_k": 0.4}, (0.1, 0.9)),
}

figure, axes = plt.subplots(2, 2, figsize=(9, 7), layout="constrained")
for ax, (name, (values, ends)) in zip(axes.flat, responses.items(), strict=True):
    branch = ns.branch(ns.scene(name)(**values), "frequency", *ends)
    print(name)
    for event in branch.events:
        print(f"  {event.kind} {event.parameter:.12f}")
    branch.plot(ax, "amplitude")
    ax.set_title(name)
every = {line.get_label(): line for ax in axes.flat for line in ax.lines}
named = {name: line for name, line in every.items() if not name.startswith("_")}
figure.legend(named.values(), named.keys(), loc="outside upper center", ncols=4)
figure.savefig("responses.png", dpi=200)
