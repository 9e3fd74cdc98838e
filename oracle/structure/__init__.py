"""Rods pinned to one another: the terms of (23), motions in free coordinates, and the rigid mechanism."""
