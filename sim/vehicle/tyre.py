"""How a tyre carries and grips, as parameters of MuJoCo's soft contacts.

While a contact is not accelerating, MuJoCo's force across it is ``(d k r + b v) / R``, with the impedance
``d`` and ``R = (1 - d) / d`` times the inverse mass seen by the contact. So a stiffness and a damping wanted
in N/m and Ns/m can be given exactly. Along the ground ``R`` is divided by ``impratio``, and friction is a
viscous force up to ``grip`` times the load. A rolling tyre pushes sideways with its cornering stiffness
``C`` times the slip angle, that is ``C v / speed``: hence ``impratio`` follows the speed, and a tyre slips
as one does, holds a standing car, and slides beyond its grip.

Reference: Pacejka 2012, "Tire and Vehicle Dynamics", sec. 1.2 (slip angle, cornering stiffness);
MuJoCo's documentation, "Solver parameters".
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco

_IMPEDANCE = 0.5
_SLIP_DECAY_PS = 250.0  # how fast slip settles; MuJoCo adds an acceleration's share of 1 / 250 s to the slip
_STANDING_MPS = 0.01  # below this speed the tyre's grip no longer grows


@dataclass(frozen=True)
class TyreConfig:
    """One tyre; SI units.

    Attributes:
        stiffness_npm: Radial.
        damping_nspm: Radial.
        cornering_npr: Side force by slip angle, N/rad; also drive force by longitudinal slip.
    """

    stiffness_npm: float = 220_000.0
    damping_nspm: float = 500.0
    cornering_npr: float = 50_000.0

    def deflection_m(self, load_n: float) -> float:
        """How far the load presses it in."""
        return load_n / self.stiffness_npm


def set_tyre(model: mujoco.MjModel, pair: str, tyre: TyreConfig, stiffer: float, grip: float) -> None:
    """Make a pair of wheel and ground that of a tyre, so many times stiffer, on a road of that grip."""
    contact = model.pair(pair)
    wheel = model.geom_bodyid[model.pair_geom1[contact.id]]
    scale = stiffer * (1 - _IMPEDANCE) * model.body_invweight0[wheel, 0]
    # Negative numbers are MuJoCo's sign for stiffness and damping instead of a time constant.
    contact.solref[:] = [-tyre.stiffness_npm * scale, -tyre.damping_nspm * scale]
    model.pair_solreffriction[contact.id] = [-1e-9, -stiffer * _IMPEDANCE * _SLIP_DECAY_PS]
    contact.solimp[:] = [_IMPEDANCE, _IMPEDANCE, 0.001, 0.5, 2.0]
    contact.friction[:2] = grip


def set_slip_speed(model: mujoco.MjModel, pair: str, tyre: TyreConfig, speed_mps: float) -> None:
    """Let every tyre slip as it does at that speed over ground; ``pair`` is one that is not stiffer."""
    wheel = model.geom_bodyid[model.pair_geom1[model.pair(pair).id]]
    softness = (1 - _IMPEDANCE) / _IMPEDANCE * model.body_invweight0[wheel, 0]
    viscosity_nspm = tyre.cornering_npr / max(abs(speed_mps), _STANDING_MPS)
    model.opt.impratio = viscosity_nspm * softness / _SLIP_DECAY_PS
