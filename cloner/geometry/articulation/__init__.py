"""Joints and skin: rotations to transforms, skinning, poses as short vectors, bends."""
