"""Stretches of an arc in different soils, and their loads after a rotation, for a unit weight.

The sum over the stretches of a quantity q of the soils, with a cumulative integral C from the entry, is

    q_last C(exit) + sum over the joints of stretches of (q_before - q_after) C(joint),

so that only C at the joints depends on the rotation, and only the differences depend on the numbers of the soils.
"""

import math
from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import ArrayDict, Floats, Integers
from slipcircle.ground.plane import sine_and_cosine
from slipcircle.layers.profile import GAUSS, PRESSING, RADIAL_X, Rule
from slipcircle.layers.standing import displaced, relieved, vertex_kinks

# Properties shared by sections that differ in numbers of soils alone.
OF_GEOMETRY = ("stretches", "rotation_kinks", "incidence")


LIKE_WEIGHTS = 2.0**14  # N/m^3, scale of water parts, since the greatest part determines the digits of tables
_DIRECT = ("space", "heads", "growth", "standing", "displaced")  # parts other than weights


class Stretches(NamedTuple):
    """Changes of the soil at the base along the arc: (circles, J) directions, and the soils before and after.

    Directions are in rad from straight below the centre, positive down-slope. Soils are indices of
    `LayeredSection.soils`, `first` and `last` of shape (circles,).
    """

    joint: Floats
    before: Integers
    after: Integers
    first: Integers
    last: Integers


@dataclass(frozen=True, eq=False)
class StretchIntegrals:
    """Integrals over the stretches of the soils along an arc as functions of the rotation, by geometry alone.

    ``section`` is a `slipcircle.layers.layers.LayeredSection`.
    """

    section: Any

    @cached_property
    def stretches(self) -> Stretches:
        """Places along the arc where the soil at the base changes, including both ends of the arc.

        The soil beyond the exit is the foreland, if there is one.
        """
        section = self.section
        strips = section._strips
        faces_right = section._facing[:, None] > 0.0
        base_from_right = strips.base[:, ::-1]
        edges_from_right = -strips.beta[:, ::-1]
        base = np.where(faces_right, strips.base, base_from_right)
        edges = np.where(faces_right, strips.beta, edges_from_right)
        if section.foreland is not None:
            base[:, -1] = len(section.layers)
        before = base[:, :-1]
        after = base[:, 1:]
        is_same = before == after
        count = np.count_nonzero(~is_same, axis=1)
        in_order = np.argsort(is_same, axis=1, kind="stable")
        place = in_order[:, : count.max(initial=0)]
        return Stretches(
            joint=np.take_along_axis(edges, place, axis=1),
            before=np.take_along_axis(before, place, axis=1),
            after=np.take_along_axis(after, place, axis=1),
            first=base[:, 0],
            last=base[:, -1],
        )

    @property
    def _joints(self) -> Floats:
        """Directions of the joints before the mass moves, (J, circles)."""
        return self.stretches.joint.T

    @property
    def _base_stays(self) -> bool:
        """Whether strength belongs to the base, over which the mass moves."""
        return bool(self.section.strength == "base")

    def _joints_met(self, rotation: Floats) -> Floats:
        """Return directions in the mass at which it meets the joints after rotations (M, circles), (J, M, circles).

        Directions and rotations are in rad. Directions refer to the mass at the start. Joints of the base stay behind
        as the mass moves.
        """
        first, last = self.section._span
        moved = rotation if self._base_stays else np.zeros_like(rotation)
        in_mass = self._joints[:, None] - moved
        return np.clip(in_mass, first, last)

    def _pressing(self, rotation: Floats, count: int, rule: Rule) -> Floats:
        """Return integrals of unit weights below surfaces up to the J joints met, (count, (J + 1) columns, M, circles).

        The integrals are the first ones of a `Profile`. They begin at the entry, with x down-slope. Rotations (pieces,
        nodes, circles) are the Chebyshev nodes of pieces; for others the `rule` is used.
        """
        profile = self.section.profile
        facing = self.section._facing
        *pieces, circles = rotation.shape
        met = self._joints_met(rotation.reshape(math.prod(pieces), circles))
        to_the_right = facing * met
        rows = len(met) * pieces[0]
        to_the_right = to_the_right.reshape(rows, *pieces[1:], circles)
        at_nodes = len(pieces) > 1
        up_to = profile.up_to_nodes(to_the_right, count) if at_nodes else profile.up_to(to_the_right, count, rule)
        joints, moments, _ = met.shape
        surfaces = up_to.shape[1]
        every = np.empty((count, joints + 1, surfaces, moments, circles))
        to_joints = every[:, :-1]
        to_joints[...] = up_to.reshape(count, surfaces, *met.shape).swapaxes(1, 2)
        whole = profile.whole[:count]
        every[:, -1] = whole[:, :, None]
        if np.any(facing < 0.0):
            np.subtract(whole[:, None, :, None], to_joints, out=to_joints, where=facing < 0.0)
            every[RADIAL_X] *= facing
        return every.reshape(count, (joints + 1) * surfaces, moments, circles)

    def parts(self, rotation: Floats, names: Collection[str], rule: Rule = GAUSS) -> ArrayDict:
        """Return parts by name, each (parts, M, circles), after rotations (M, circles) in rad.

        All weights are computed together, by a `rule`. Rotations (pieces, nodes, circles) are the Chebyshev nodes of
        pieces, one piece after the other in the results.
        """
        by_piece = rotation
        *lead, circles = by_piece.shape
        rotation = by_piece.reshape(math.prod(lead), circles)
        every = {name: getattr(self, name)(rotation) for name in _DIRECT if name in names}
        if len(every) < len(names):
            # Parts of the weight: J(psi - phi) = J cos(phi) - J' sin(phi), its slope, I_p, and cover.
            count = PRESSING if "overburden" in names else PRESSING - 1
            radial_y, radial_x, polar, *cover = self._pressing(by_piece, count, rule)
            sine, cosine = sine_and_cosine(rotation)
            slope = radial_x * sine
            normal = -radial_y * cosine - slope
            tilt = radial_x * cosine - radial_y * sine
            every |= {"normal": normal, "tilt": tilt, "inertia": polar}
            if cover:
                (every["overburden"],) = cover
        return every

    def space(self, rotation: Floats) -> Floats:
        """Return directions in space of the joints, the exit and the entry after rotations, (J + 2, M, circles)."""
        first, last = self.section._span
        start = first + rotation
        end = last + rotation
        joints = self._joints[:, None]
        in_space = np.clip(joints, start, end) if self._base_stays else joints + rotation
        return np.stack([*in_space, end, start])

    def heads(self, rotation: Floats) -> Floats:
        """Return integrals of the head of the water level from the entry to these directions, (J + 2, M, circles).

        The directions in space are joints, exit and entry after rotations (M, circles) in rad.
        """
        there = self.section._facing * self.space(rotation)
        *_, entry = there
        left = np.minimum(entry, there)
        right = np.maximum(entry, there)
        return self.section.heads_between(left, right)

    def standing(self, rotation: Floats) -> Floats:
        """Return the reduction of the normal force by standing water from the entry, (J + 2, M, circles).

        The rotations are (M, circles) in rad, and the integrals end at joints, exit and entry. The result is multiplied
        by `LIKE_WEIGHTS`.
        """
        first, last = self.section._span
        joints = self._joints_met(rotation)
        to_exit = np.broadcast_to(last, rotation.shape)
        to_entry = np.broadcast_to(first, rotation.shape)
        directions = np.stack([*joints, to_exit, to_entry])
        normal, _ = displaced(self.section, rotation, directions)
        there = self.space(rotation)
        *_, entry = there
        pressure = relieved(self.section.standing_level, entry, there)
        taken = normal - pressure
        return LIKE_WEIGHTS * taken

    def displaced(self, rotation: Floats) -> Floats:
        """Return the moment of displaced water over the moment of inertia of a unit density, (1, M, circles).

        The rotations are (M, circles) in rad. The result is multiplied by `LIKE_WEIGHTS`.
        """
        nowhere = np.empty((0, *rotation.shape))
        _, moment = displaced(self.section, rotation, nowhere)
        inertia = self.section._moments["inertia"]
        over_inertia = moment / inertia
        return LIKE_WEIGHTS * over_inertia[None]

    def growth_up_to(self, there: Floats) -> Floats:
        """Return integrals of the depth below each soil's datum from the entry to directions (..., circles), over R.

        The shape is (soils, ..., circles), with 0 for soils without growth.
        """
        has_foreland = self.section.foreland is not None
        limit = np.inf if has_foreland else None  # the growth in a foreland continues beyond the exit
        by_soil = np.zeros((len(self.section.depths), *there.shape))
        for k, depths in enumerate(self.section.depths):
            if depths is not None:
                by_soil[k] = depths.integral(there, limit)
        return by_soil

    def growth(self, rotation: Floats) -> Floats:
        """Return parts of the resistance that grow with depth, one per soil, (soils, M, circles), over R.

        The rotations are (M, circles) in rad.
        """
        there = self.space(rotation)
        if not self._base_stays:
            there = there - rotation
        growth = self.growth_up_to(there)
        by_direction = self.incidence[:, :, None] * growth
        parts = by_direction.sum(axis=1)
        return parts

    @cached_property
    def rotation_kinks(self) -> Floats:
        """Rotations in rad at which one of these functions is not smooth, (kinks, circles), sorted."""
        section = self.section
        ends = np.stack(section._span, axis=1)
        joints = self.stretches.joint
        facing = section._facing[:, None]
        opening = np.diff(ends, axis=1)
        kinks = [opening]
        if section.level is not None:
            of_level = section._water.kinks * facing
            turning = ends
            if not self._base_stays:
                turning = np.concatenate([ends, joints], axis=1)
            kinks.append(_differences(of_level, turning))
        if section.in_standing_water:
            kinks.append(vertex_kinks(section))
        if self._base_stays:
            strips = section._strips.beta * facing
            kinks.append(_differences(joints, strips))
            for depths in filter(None, section.depths):
                kinks.append(_differences(depths.kinks, ends))
        every = np.concatenate(kinks, axis=1)
        return np.sort(every, axis=1).T

    @cached_property
    def incidence(self) -> Floats:
        """Differences (q_before - q_after) at joints, q_last and -q_first, (soils, J + 2, circles).

        The sum of q over the stretches with a cumulative integral C from the entry is q_last C(exit) + sum_j (q_before
        - q_after)_j C(b_j). For an integral from another origin the last row subtracts its value at the entry.
        """
        joints = self.stretches
        of_soil = np.eye(len(self.section.soils))
        before = of_soil[joints.before.T]
        after = of_soil[joints.after.T]
        at_exit = of_soil[joints.last]
        at_entry = of_soil[joints.first]
        at_joints = before - after
        by_soil = np.stack([*at_joints, at_exit, -at_entry])
        return by_soil.transpose(2, 0, 1)


def _differences(there: Floats, mass: Floats) -> Floats:
    """Return rotations that bring directions of the mass to directions in space, (circles, N M).

    Directions in space are (circles, N) and directions of the mass (circles, M), in rad.
    """
    of_place = there[:, :, None]
    of_mass = mass[:, None, :]
    rotations = of_place - of_mass
    return rotations.reshape(len(there), -1)
