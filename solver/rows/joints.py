"""The conditions that join the phases of any scene: continuity, jumps, events, memory, closure.

A case is the arrays `kinds`, `numbers`, `setting`, `memory`, `cell` of `scenes.arrays`; columns
of the first two are named here.  `theta` has the angles of the forcing at the switches.

The unknowns z are: for each phase from ``at[p]`` on, the state at its begin and further
unknowns of the phase; then the memories, the durations, and the phase of the forcing.  The
motion within the phases is given by the caller:

gained : ndarray, shape (P, derivatives)
    Change of displacement and velocity over the phase; from the second derivative on, the
    values of the derivatives at its end.
begins : ndarray, shape (P, derivatives)
    From the second derivative on, the values at its begin.
gained_by, begins_by : ndarray, shape (P, derivatives, 3 + width)
    Their derivatives: by the duration of the phase, by the angle of the forcing at its begin,
    by its constant force, and by the unknowns of the phase.
"""

from math import cos, pi, sin

# Columns of `kinds`: whether the phase is free; the class at its begin; the number of unknowns
# added to a series (polynomials orthogonal to all tests, or functions with a break at its
# begin); where displacement and velocity of its event are taken: at its end, after the switch
# there, or at its begin.
FREE, CLASS, BESIDE, OF_X, OF_V = 0, 1, 2, 3, 4
AT_END, AFTER, AT_BEGIN = 0, 1, 2

# Columns of `numbers`: m x'' + c x' + k x = f + g cos; the velocity after the phase, rho v +
# jump; its event, a linear form in x, v, cos and 1; then the factors of each memory on the
# right side, and in the event.
M, C, K, F, G, RHO, JUMP, E_X, E_V, E_COS, E_0, MEMORY = 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11


def highest(kinds, q):
    """Return the highest order of a derivative with a condition at the begin of phase q."""
    return max(1, kinds[q, CLASS]) if kinds[q, FREE] else 1


def fill_angles(case, z, at, theta):
    """Fill `theta` with the angles of the forcing at the switches and the end of the cell."""
    kinds, _, setting, _, cell = case[:5]
    count, at_s = len(kinds), at[len(kinds)] + len(setting)
    theta[0] = z[len(z) - 1] if cell[2] != 0 else 0.0
    for p in range(count):
        theta[p + 1] = theta[p] + cell[1] * z[at_s + p]


def event(case, z, at, gained, theta, p):
    """Return the event function of phase p at its begin, and its change up to its end.

    They are kept apart so that the sum has no cancellation if a phase begins at its own event.
    """
    kinds, numbers, setting, _, cell = case[:5]
    count, memories = len(kinds), len(setting)
    q = p + 1 if p + 1 < count else 0
    sign = cell[0] if q == 0 else 1.0
    value, change = numbers[p, E_0], 0.0
    for order in range(2):
        state = kinds[p, OF_X + order]
        component = sign * z[at[q] + order] if state == AFTER else z[at[p] + order]
        value = value + numbers[p, E_X + order] * component
        if state == AT_END:
            change = change + numbers[p, E_X + order] * gained[p, order]
    for i in range(memories):
        value = value + numbers[p, MEMORY + memories + i] * z[at[count] + i]
    if cell[2] != 0:
        half = cell[1] * z[at[count] + memories + p] / 2
        cosine_change = -2 * sin(theta[p] + half) * sin(half)
        value = value + numbers[p, E_COS] * cos(theta[p])
        change = change + numbers[p, E_COS] * cosine_change
    return value, change


def joints(case, z, at, theta, gained, begins, R, row):
    """Fill R, from `row` on, with the residuals of the conditions that join the phases."""
    kinds, numbers, setting, memory, cell = case[:5]
    count, memories, forced = len(kinds), len(setting), cell[2] != 0
    at_w = at[count]
    for q in range(count):
        p = q - 1 if q > 0 else count - 1
        sign = cell[0] if q == 0 else 1.0
        rho, jump = numbers[p, RHO], numbers[p, JUMP]
        # states first: the changes may be far smaller
        R[row] = z[at[q]] - sign * z[at[p]] - sign * gained[p, 0]
        law = rho * z[at[p] + 1] + jump
        R[row + 1] = z[at[q] + 1] - sign * law - sign * rho * gained[p, 1]
        row += 2
        for order in range(2, highest(kinds, q) + 1):
            R[row] = begins[q, order] - sign * gained[p, order]
            row += 1
    for p in range(count):
        value, change = event(case, z, at, gained, theta, p)
        R[row] = value + change
        row += 1
    for i in range(memories):
        p = setting[i]
        value = memory[i, 0] * z[at[p]] + memory[i, 1] * z[at[p] + 1] + memory[i, 3]
        if forced:
            value = value + memory[i, 2] * cos(theta[p])
        R[row] = z[at_w + i] - value
        row += 1
    if forced:
        total = -cell[2] * pi / cell[1]
        for p in range(count):
            total = total + z[at_w + memories + p]
        R[row] = total


def add_joint(case, J, row, factor, by, at, p):
    """Add a factor times `by`, from `gained_by` or `begins_by` of phase p, to a row of J."""
    kinds, numbers, setting, _, cell = case[:5]
    count, memories = len(kinds), len(setting)
    at_w, at_s = at[count], at[count] + memories
    J[row, at_s + p] += factor * by[0]
    if cell[2] != 0:
        add_angle(J, row, factor * by[1], cell[1], at_s, p)
    for i in range(memories):
        J[row, at_w + i] += factor * by[2] * numbers[p, MEMORY + i]
    for j in range(min(at[p + 1] - at[p], len(by) - 3)):
        J[row, at[p] + j] += factor * by[3 + j]


def add_angle(J, row, factor, omega, at_s, count):
    """Add a factor times the derivatives of ``theta[count]`` to a row of J."""
    J[row, J.shape[1] - 1] += factor
    for q in range(count):
        J[row, at_s + q] += omega * factor


def add_event(case, J, row, at, gained_by, theta, p, of_value, of_change):
    """Add to a row the derivatives of both results of `event`, times the last two factors."""
    kinds, numbers, setting, _, cell = case[:5]
    count, memories = len(kinds), len(setting)
    at_w = at[count]
    q = p + 1 if p + 1 < count else 0
    sign = cell[0] if q == 0 else 1.0
    for order in range(2):
        state, weight = kinds[p, OF_X + order], numbers[p, E_X + order]
        if state == AFTER:
            J[row, at[q] + order] += of_value * sign * weight
        else:
            J[row, at[p] + order] += of_value * weight
        if state == AT_END and weight != 0:
            add_joint(case, J, row, of_change * weight, gained_by[p, order], at, p)
    for i in range(memories):
        J[row, at_w + i] += of_value * numbers[p, MEMORY + memories + i]
    if cell[2] != 0:
        weight = numbers[p, E_COS]
        before, behind = weight * sin(theta[p]), weight * sin(theta[p + 1])
        if of_value != of_change:
            add_angle(J, row, (of_change - of_value) * before, cell[1], at_w + memories, p)
        add_angle(J, row, -of_change * behind, cell[1], at_w + memories, p + 1)


def joint_rates(case, z, at, theta, gained_by, begins_by, J, row):
    """Add the derivatives of `joints` to J, from `row` on; these rows of J are zero before."""
    kinds, numbers, setting, memory, cell = case[:5]
    count, memories, forced = len(kinds), len(setting), cell[2] != 0
    at_w = at[count]
    for q in range(count):
        p = q - 1 if q > 0 else count - 1
        sign = cell[0] if q == 0 else 1.0
        J[row, at[q]] += 1.0
        add_joint(case, J, row, -sign, gained_by[p, 0], at, p)
        J[row, at[p]] -= sign
        J[row + 1, at[q] + 1] += 1.0
        add_joint(case, J, row + 1, -sign * numbers[p, RHO], gained_by[p, 1], at, p)
        J[row + 1, at[p] + 1] -= sign * numbers[p, RHO]
        row += 2
        for order in range(2, highest(kinds, q) + 1):
            add_joint(case, J, row, 1.0, begins_by[q, order], at, q)
            add_joint(case, J, row, -sign, gained_by[p, order], at, p)
            row += 1
    for p in range(count):
        add_event(case, J, row, at, gained_by, theta, p, 1.0, 1.0)
        row += 1
    for i in range(memories):
        p = setting[i]
        J[row, at_w + i] += 1.0
        J[row, at[p]] -= memory[i, 0]
        J[row, at[p] + 1] -= memory[i, 1]
        if forced:
            add_angle(J, row, memory[i, 2] * sin(theta[p]), cell[1], at_w + memories, p)
        row += 1
    for p in range(count if forced else 0):
        J[row, at_w + memories + p] += 1.0
