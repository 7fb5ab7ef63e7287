"""Rigid transforms as immutable values.

The tangent is (rotation, translation) and perturbs on the right, ``x.retract(d) = x @ SE3.exp(d)``, the
convention of ``gtsam.Pose3``, so covariances pass between the two unchanged.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

Array = npt.NDArray[np.float64]


def skew(vector: Array) -> Array:
    """Return the (..., 3, 3) cross-product matrices of (..., 3) vectors."""
    x, y, z = np.moveaxis(np.asarray(vector, float), -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], -1).reshape((*x.shape, 3, 3))


def _left_jacobian(omega: Array) -> Array:
    """Return the (3, 3) left Jacobian of SO(3). Reference: Barfoot 2017, eq. 7.77."""
    angle = float(np.linalg.norm(omega))
    cross = skew(omega)
    if angle < 1e-5:
        return np.eye(3) + 0.5 * cross + cross @ cross / 6.0
    a = 0.5 * (np.sin(0.5 * angle) / (0.5 * angle)) ** 2  # (1 - cos) / angle^2 without its cancellation
    b = (angle - np.sin(angle)) / angle**3
    return np.asarray(np.eye(3) + a * cross + b * cross @ cross)


@dataclass(frozen=True, eq=False)
class SE3:
    """A rigid transform ``a_from_b``: ``p_a = a_from_b @ p_b``.

    Attributes:
        rotation: (3, 3) orthonormal matrix.
        translation: (3,) in metres.
    """

    rotation: Array = field(default_factory=lambda: np.eye(3))
    translation: Array = field(default_factory=lambda: np.zeros(3))

    def __post_init__(self) -> None:
        rotation = np.array(self.rotation, dtype=float)
        translation = np.array(self.translation, dtype=float)
        if rotation.shape != (3, 3) or translation.shape != (3,):
            raise ValueError(f"SE3 needs (3, 3) and (3,), got {rotation.shape} and {translation.shape}")
        rotation.flags.writeable = translation.flags.writeable = False
        object.__setattr__(self, "rotation", rotation)
        object.__setattr__(self, "translation", translation)

    @staticmethod
    def exp(tangent: Array) -> SE3:
        """Map a (6,) tangent (rotation in rad, translation in m) to a transform."""
        tangent = np.asarray(tangent, float)
        omega = tangent[:3]
        return SE3(Rotation.from_rotvec(omega).as_matrix(), _left_jacobian(omega) @ tangent[3:])

    @staticmethod
    def from_quaternion_xyzw(quaternion_xyzw: Array, translation: Array) -> SE3:
        """Build from a quaternion, which is normalised, and a translation in metres."""
        return SE3(Rotation.from_quat(np.asarray(quaternion_xyzw, float)).as_matrix(), translation)

    @staticmethod
    def from_matrix(matrix: Array) -> SE3:
        """Build from a (4, 4) homogeneous matrix."""
        return SE3(matrix[:3, :3], matrix[:3, 3])

    def log(self) -> Array:
        """Return the (6,) tangent, the inverse of ``exp``."""
        omega = Rotation.from_matrix(self.rotation).as_rotvec()
        return np.concatenate([omega, np.linalg.solve(_left_jacobian(omega), self.translation)])

    def inverse(self) -> SE3:
        return SE3(self.rotation.T, -self.rotation.T @ self.translation)

    def __matmul__(self, other: SE3) -> SE3:
        return SE3(self.rotation @ other.rotation, self.rotation @ other.translation + self.translation)

    def apply(self, points_b: Array) -> Array:
        """Move (..., 3) points from frame b to frame a."""
        return np.asarray(np.asarray(points_b) @ self.rotation.T + self.translation)

    def retract(self, tangent: Array) -> SE3:
        """Perturb on the right by a (6,) tangent."""
        return self @ SE3.exp(tangent)

    def local(self, other: SE3) -> Array:
        """Return the (6,) tangent d with ``self.retract(d) == other``."""
        return (self.inverse() @ other).log()

    def adjoint(self) -> Array:
        """Return the (6, 6) adjoint: ``x @ exp(d) == exp(x.adjoint() @ d) @ x``."""
        result = np.zeros((6, 6))
        result[:3, :3] = result[3:, 3:] = self.rotation
        result[3:, :3] = skew(self.translation) @ self.rotation
        return result

    @property
    def quaternion_xyzw(self) -> Array:
        """The (4,) unit quaternion with w >= 0."""
        quaternion = Rotation.from_matrix(self.rotation).as_quat()
        return np.asarray(quaternion if quaternion[3] >= 0 else -quaternion)

    @property
    def matrix(self) -> Array:
        """The (4, 4) homogeneous matrix."""
        result = np.eye(4)
        result[:3, :3], result[:3, 3] = self.rotation, self.translation
        return result

    @property
    def angle_rad(self) -> float:
        """The rotation angle."""
        return float(np.linalg.norm(Rotation.from_matrix(self.rotation).as_rotvec()))
