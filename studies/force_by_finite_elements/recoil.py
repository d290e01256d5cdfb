"""What recoil takes from the force, to first order in recoil permeability - 1, without finite elements.

A magnet of polarisation J has the field H of its own; recoil adds chi H to its magnetisation, which differs from point to
point. The coil's force on that addition is the integral of chi mu0 H . dB/dz over the magnet, B being the coil's. Both
fields are those of thin solenoids (Derby and Olbert, Am. J. Phys. 78, 229, 2010, eq. 4 to 6), the coil is a bundle of them, and
the integrals are Gauss's. Lengths in m.
"""

import math

MU0 = 4e-7 * math.pi


def cel(kc: float, p: float, a: float, b: float) -> float:
    """Bulirsch's complete elliptic integral (Numer. Math. 13, 305, 1969), p > 0."""
    e, m, p = kc, 1.0, math.sqrt(p)
    b /= p
    while True:
        f, g = a, e / p
        a, b, p = a + b / p, 2 * (b + f * g), p + g
        g, m = m, m + kc
        if abs(g - kc) <= 1e-9 * g:
            return math.pi / 2 * (b + a * m) / (m * (m + p))
        kc = 2 * math.sqrt(e)
        e = kc * m


def solenoid(radius: float, length: float, sheet: float, rho: float, z: float) -> tuple[float, float]:
    """B along rho and z of a sheet of `sheet` A/m round a cylinder, T."""
    g = (radius - rho) / (radius + rho)
    along_rho = along_z = 0.0
    for sign in (1, -1):
        end = z + sign * length / 2
        far = math.hypot(end, radius + rho)
        k = math.hypot(end, radius - rho) / far
        along_rho += sign * radius / far * cel(k, 1, 1, -1)
        along_z += sign * end / far * cel(k, g * g, 1, g)
    scale = MU0 * sheet / math.pi
    return scale * along_rho, scale * radius / (radius + rho) * along_z


def gauss(n: int, low: float, high: float) -> list[tuple[float, float]]:
    """Nodes and weights of Gauss and Legendre by Newton's method."""
    rule = []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(50):
            before, now = 1.0, x
            for j in range(2, n + 1):
                before, now = now, ((2 * j - 1) * x * now - (j - 1) * before) / j
            slope = n * (x * now - before) / (x * x - 1)
            step = now / slope
            x -= step
            if abs(step) < 1e-15:
                break
        rule.append(((low + high) / 2 + (high - low) / 2 * x, (high - low) / ((1 - x * x) * slope * slope)))
    return rule


def force_and_slope(nodes: int = 24, distance: float = 9.9e-3) -> tuple[float, float]:
    """Force between the paper's coil at 1.4 A and its rigid magnet, N, and its relative change over chi."""
    magnet_radius, magnet_length, polarisation = 10e-3, 6e-3, 1.44
    layers = gauss(16, 3e-3, 9.5e-3)
    density = 450 * 1.4 / (6.5e-3 * 12e-3)

    def coil(rho: float, z: float) -> tuple[float, float]:
        parts = [(w, solenoid(r, 12e-3, density, rho, z)) for r, w in layers]
        return sum(w * b[0] for w, b in parts), sum(w * b[1] for w, b in parts)

    rigid = change = 0.0
    step = 2e-5
    for rho, w_rho in gauss(nodes, 0, magnet_radius):
        for z, w_z in gauss(nodes, -magnet_length / 2, magnet_length / 2):
            ahead, behind = coil(rho, distance + z + step), coil(rho, distance + z - step)
            gradient = [(a - b) / (2 * step) for a, b in zip(ahead, behind)]
            own = solenoid(magnet_radius, magnet_length, polarisation / MU0, rho, z)
            volume = 2 * math.pi * rho * w_rho * w_z
            rigid += volume * polarisation / MU0 * gradient[1]
            change += volume / MU0 * (own[0] * gradient[0] + (own[1] - polarisation) * gradient[1])
    return abs(rigid), change / rigid
