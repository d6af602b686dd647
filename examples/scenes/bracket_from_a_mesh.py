"""A steel bracket, meshed by scikit-fem, with an elastic stop at its tip (C2)."""

import numpy as np
import sympy as sp
from skfem import Basis, BilinearForm, ElementQuad2, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

LEG, WIDTH, THICKNESS = 0.2, 0.02, 0.005  # m
YOUNG, POISSON, DENSITY = 2.1e11, 0.3, 7800.0  # N/m^2, 1, kg/m^3

line = np.linspace(0, LEG, 11)
mesh = MeshQuad.init_tensor(line, line)  # an L: a square without its upper right
mesh = mesh.restrict(np.flatnonzero(mesh.p[:, mesh.t].mean(axis=1).min(axis=0) < WIDTH))
basis = Basis(mesh, ElementVector(ElementQuad2()))
lam, mu = lame_parameters(YOUNG, POISSON)
elasticity = linear_elasticity(2 * lam * mu / (lam + 2 * mu), mu)  # plane stress
mass = BilinearForm(lambda u, v, w: DENSITY * (u[0] * v[0] + u[1] * v[1]))
free = basis.complement_dofs(basis.get_dofs(lambda q: q[1] == LEG))  # its upper end is held
x, y = basis.doflocs[:, free]
K = THICKNESS * elasticity.assemble(basis)[free][:, free]
M = THICKNESS * mass.assemble(basis)[free][:, free]
tip = np.eye(len(free))[np.flatnonzero((x == LEG) & (y == 0))[1]]  # it moves vertically

k, g, Omega = sp.symbols("k g Omega", positive=True)
BRACKET = Body(M=M, K=K, ratio=0.01, modes=12, forcing=10 * tip, at={"tip": tip})
TIP = BRACKET.at["tip"]
TOUCH = Phase("touch", TIP.force + k * (TIP.x - g), Event(TIP.x - g), {"it presses": TIP.x - g})
FREE = Phase("free", TIP.force, Event(TIP.x - g), {"it is before the stop": g - TIP.x})

SCENE = Scene(
    "bracket-and-stop",
    "a steel bracket with an elastic stop at its tip",
    body=BRACKET,
    parameters=(
        Parameter("stop", k, "N/m", 2e4, "stiffness of the stop"),
        Parameter("gap", g, "m", 1e-4, "displacement of the tip at the stop"),
        Parameter("frequency", Omega, "rad/s", 400.0, "angular frequency of the force"),
    ),
    phases=(TOUCH, FREE),
    frequency=Omega,
)
