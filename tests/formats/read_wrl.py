"""Run by the system's Python, which has Coin: reads one .wrl and prints what it found as JSON."""

import json
import sys

from pivy import coin


def main(path):
    source = coin.SoInput()
    if not source.openFile(path):
        sys.exit("cannot open")
    root = coin.SoDB.readAll(source)
    if root is None:
        sys.exit("does not parse")
    root.ref()
    box = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    box.apply(root)
    bounds = box.getBoundingBox()  # keep it: its corners are views into it
    low, high = list(bounds.getMin().getValue()), list(bounds.getMax().getValue())
    counter = coin.SoGetPrimitiveCountAction()
    counter.apply(root)
    found = {"low": low, "high": high, "triangles": counter.getTriangleCount(), "nodes": {}}
    for name in sys.argv[2:]:
        found["nodes"][name] = coin.SoNode.getByName(name) is not None
    sys.stdout.write(json.dumps(found))


main(sys.argv[1])
