"""A scene as an Exudyn system of cable elements, or of beams with shear."""

import math
from collections import defaultdict
from itertools import pairwise

from .options import BEAM
from .program import exu, item

# Mass (kg) of a body at the hinge for explicit solvers. Exudyn's explicit solvers hold a coordinate by setting its
# acceleration to zero after solving with the full mass matrix. Where masses are coupled, as in this element, the motion is
# wrong (0.1 m here) without a warning. A body this heavy reduces the error to 1e-12.
ANCHOR = 1e12


class Model:
    """The system `mbs`, ready to solve, and its `sensors` at the probe: the position's, and the velocity's if asked for."""

    def __init__(self, scene, options, with_velocity=False):
        if options.is_explicit and len(scene.rods) > 1:
            raise ValueError("the peer's explicit solvers have no pins between rods")
        if options.element == BEAM and (scene.history or options.is_explicit):
            raise ValueError("the peer's beam with shear has no thermal strain, and no hinge in explicit methods")
        self.scene, self.options = scene, options
        self.container = exu.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.ground = self.mbs.AddNode(item.NodePointGround())
        self.strain = scene.thermal_strain(0.0)
        self.cables, self.nodes_at = [], defaultdict(list)  # all nodes at a point or pivot, one of each rod
        for rod in scene.rods:
            self.add_beam(rod) if options.element == BEAM else self.add_rod(rod)
        for nodes in self.nodes_at.values():
            for other in nodes[1:]:
                self.tie(nodes[0], other, (0, 1))
        for point, axes in scene.fixed:
            self.hold(self.nodes_at[point][0], axes)
        for point, force in scene.forces:
            self.load(self.nodes_at[point][0], force)
        kinds = exu.OutputVariableType
        self.sensors = [self.mbs.AddSensor(item.SensorNode(
            nodeNumber=self.nodes_at[scene.probe][0], outputVariableType=kind, storeInternal=True, writeToFile=False))
            for kind in ([kinds.Position, kinds.Velocity] if with_velocity else [kinds.Position])]
        if scene.is_heated_in_time:
            self.mbs.SetPreStepUserFunction(self.heat)
        self.mbs.Assemble()

    def add_rod(self, rod):
        """Adds nodes, elements and weight of one rod. A relaxed start stretches it from its hinge at the origin."""
        scene, count = self.scene, self.options.elements
        start, end = (scene.points[name] for name in rod.ends)
        length = scene.length(rod)
        slope = [(b - a) / length for a, b in zip(start, end)]
        stretch = scene.thermal_strain(0.0) if scene.relaxed else 0.0
        nodes = []
        for k in range(count + 1):
            reference = [a + (b - a) * k / count for a, b in zip(start, end)] + slope
            nodes.append(self.mbs.AddNode(item.NodePoint2DSlope1(
                referenceCoordinates=reference, initialCoordinates=[stretch * c for c in reference])))
        for pair in pairwise(nodes):
            self.cables.append(self.mbs.AddObject(item.ObjectANCFCable2D(
                length=length / count, massPerLength=scene.rho_A, axialStiffness=scene.EA, bendingStiffness=scene.EI,
                axialDamping=0.0, bendingDamping=0.0, referenceAxialStrain=self.strain,
                nodeNumbers=list(pair), useReducedOrderIntegration=self.options.integration)))
        self.add_weight(nodes, length / count)
        if rod.pivot:
            if count % 2:
                raise ValueError(f"a rod pinned at its middle needs an even number of elements, not {count}")
            self.nodes_at[rod.pivot].append(nodes[count // 2])
        for name, node in zip(rod.ends, (nodes[0], nodes[-1])):
            self.nodes_at[name].append(node)

    def add_beam(self, rod):
        """Adds nodes, elements and weight of one rod as a geometrically exact beam: three nodes to an element, full shear stiffness."""
        scene, count = self.scene, self.options.elements
        start, end = (scene.points[name] for name in rod.ends)
        length, places = scene.length(rod) / count, 2 * count
        angle = math.atan2(end[1] - start[1], end[0] - start[0])
        nodes = [self.mbs.AddNode(item.NodeRigidBody2D(
            referenceCoordinates=[a + (b - a) * k / places for a, b in zip(start, end)] + [angle])) for k in range(places + 1)]
        for first in range(0, places, 2):
            body = self.mbs.AddObject(item.ObjectBeamGeometricallyExact2D(
                nodeNumbers=nodes[first:first + 3], length=length, massPerLength=scene.rho_A,
                crossSectionInertia=scene.rho_A * scene.EI / scene.EA, bendingStiffness=scene.EI, axialStiffness=scene.EA,
                shearStiffness=scene.GA, includeReferenceRotations=True))
            if any(scene.gravity):
                marker = self.mbs.AddMarker(item.MarkerBodyMass(bodyNumber=body))
                self.mbs.AddLoad(item.LoadMassProportional(markerNumber=marker, loadVector=[*scene.gravity, 0]))
        if rod.pivot:
            self.nodes_at[rod.pivot].append(nodes[count])
        for name, node in zip(rod.ends, (nodes[0], nodes[-1])):
            self.nodes_at[name].append(node)

    def add_weight(self, nodes, length):
        """Adds gravity as constant nodal forces; those on inner slopes cancel.

        The result equals that of Exudyn's mass-proportional load on every element to the last digits, and is never slower.
        """
        weight = [self.scene.rho_A * length * g for g in self.scene.gravity]
        ends = (nodes[0], nodes[-1])
        for node in nodes:
            self.load(node, [w / 2 if node in ends else w for w in weight])
        for node, sign in zip(ends, (1, -1)):
            self.load(node, [sign * w * length / 12 for w in weight], first=2)

    def coordinate(self, node, axis):
        """A marker of one coordinate of a node: position x, y, slope x, y. The ground has a single one, zero."""
        axis = 0 if node == self.ground else axis
        return self.mbs.AddMarker(item.MarkerNodeCoordinate(nodeNumber=node, coordinate=axis))

    def load(self, node, force, first=0):
        """Adds a constant force on two coordinates of a node: position (first = 0) or slope (first = 2)."""
        for axis, value in enumerate(force, first):
            if value:
                self.mbs.AddLoad(item.LoadCoordinate(markerNumber=self.coordinate(node, axis), load=value))

    def tie(self, one, other, axes):
        """Ties the displacements of two nodes along some axes. Exudyn's revolute joint takes as long."""
        for axis in axes:
            markers = [self.coordinate(node, axis) for node in (one, other)]
            self.mbs.AddObject(item.ObjectConnectorCoordinate(markerNumbers=markers))

    def hold(self, node, axes):
        """Holds a node along some axes."""
        self.tie(self.ground, node, axes)
        if self.options.is_explicit and self.options.anchored:
            self.mbs.AddObject(item.ObjectMassPoint2D(physicsMass=ANCHOR, nodeNumber=node))

    def heat(self, mbs, t):
        """Sets the temperature; Exudyn calls it before each step with the time of the step's end.

        Setting a parameter takes microseconds, so that it is done only while the temperature changes.
        """
        strain = self.scene.thermal_strain(t)
        if strain != self.strain:
            self.strain = strain
            for cable in self.cables:
                mbs.SetObjectParameter(cable, "referenceAxialStrain", strain)
        return True
