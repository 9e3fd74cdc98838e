"""A scene as an Exudyn system of ANCFCable2D elements."""

from collections import defaultdict
from itertools import pairwise

from .program import exu, item

# Exudyn's explicit solvers hold a coordinate by setting its acceleration to zero after they solved with the whole mass
# matrix, which is not that of what remains: where masses are coupled, as in this element, the motion is wrong (0.1 m
# here) and nothing says so. A body this heavy (kg) at the hinge makes both the same but for 1e-12.
ANCHOR = 1e12


class Model:
    """The system `mbs`, ready to solve, and its `sensor` at the probe."""

    def __init__(self, scene, options):
        if options.is_explicit and len(scene.rods) > 1:
            raise ValueError("the peer's explicit solvers know no pins between rods")
        self.scene, self.options = scene, options
        self.container = exu.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.ground = self.mbs.AddNode(item.NodePointGround())
        self.strain = scene.thermal_strain(0.0)
        self.cables, self.nodes_at = [], defaultdict(list)  # all nodes at a point or pivot, one of each rod
        for rod in scene.rods:
            self.add_rod(rod)
        for nodes in self.nodes_at.values():
            for other in nodes[1:]:
                self.tie(nodes[0], other, (0, 1))
        for point, axes in scene.fixed:
            self.hold(self.nodes_at[point][0], axes)
        for point, force in scene.forces:
            self.load(self.nodes_at[point][0], force)
        self.sensor = self.mbs.AddSensor(item.SensorNode(
            nodeNumber=self.nodes_at[scene.probe][0], outputVariableType=exu.OutputVariableType.Position,
            storeInternal=True, writeToFile=False))
        if scene.is_heated_in_time:
            self.mbs.SetPreStepUserFunction(self.heat)
        self.mbs.Assemble()

    def add_rod(self, rod):
        """Nodes, elements and weight of one rod. A relaxed start stretches it away from the origin, its hinge."""
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
                raise ValueError(f"a rod that is pinned at its middle needs an even number of elements, not {count}")
            self.nodes_at[rod.pivot].append(nodes[count // 2])
        for name, node in zip(rod.ends, (nodes[0], nodes[-1])):
            self.nodes_at[name].append(node)

    def add_weight(self, nodes, length):
        """Gravity as the constant nodal forces that it is; those on inner slopes cancel.

        The same as Exudyn's mass-proportional load on every element to the last digits, and never slower.
        """
        weight = [self.scene.rho_A * length * g for g in self.scene.gravity]
        ends = (nodes[0], nodes[-1])
        for node in nodes:
            self.load(node, [w / 2 if node in ends else w for w in weight])
        for node, sign in zip(ends, (1, -1)):
            self.load(node, [sign * w * length / 12 for w in weight], first=2)

    def coordinate(self, node, axis):
        """A marker of one of a node's coordinates: position x, y, slope x, y. The ground has one, which is zero."""
        axis = 0 if node == self.ground else axis
        return self.mbs.AddMarker(item.MarkerNodeCoordinate(nodeNumber=node, coordinate=axis))

    def load(self, node, force, first=0):
        """A constant force on two coordinates of a node: its position (first = 0) or its slope (2)."""
        for axis, value in enumerate(force, first):
            if value:
                self.mbs.AddLoad(item.LoadCoordinate(markerNumber=self.coordinate(node, axis), load=value))

    def tie(self, one, other, axes):
        """The same displacement of two nodes along some axes. Exudyn's revolute joint takes as long."""
        for axis in axes:
            markers = [self.coordinate(node, axis) for node in (one, other)]
            self.mbs.AddObject(item.ObjectConnectorCoordinate(markerNumbers=markers))

    def hold(self, node, axes):
        """A node held along some axes."""
        self.tie(self.ground, node, axes)
        if self.options.is_explicit and self.options.anchored:
            self.mbs.AddObject(item.ObjectMassPoint2D(physicsMass=ANCHOR, nodeNumber=node))

    def heat(self, mbs, t):
        """Called by Exudyn before each step with the time at the step's end, where its equations hold.

        Setting a parameter takes microseconds, so it is done while the temperature changes only.
        """
        strain = self.scene.thermal_strain(t)
        if strain != self.strain:
            self.strain = strain
            for cable in self.cables:
                mbs.SetObjectParameter(cable, "referenceAxialStrain", strain)
        return True
