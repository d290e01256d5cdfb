"""The regions into which straight sides divide a plane."""

import math


def area(loop):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:] + loop[:1]))


def contains(loop, point):
    inside = False
    for a, b in zip(loop, loop[1:] + loop[:1]):
        if (a[1] > point[1]) != (b[1] > point[1]) and \
                point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
            inside = not inside
    return inside


def faces(sides):
    """Bounded regions as (outer loop, holes), loops of points. Sides meet at their ends only."""
    neighbours = {}
    for a, b in sides:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    for point, ends in neighbours.items():
        ends.sort(key=lambda end, at=point: math.atan2(end[1] - at[1], end[0] - at[0]))
    left = {(a, b) for a in neighbours for b in neighbours[a]}
    outer, inner = [], []
    while left:
        start = edge = min(left)
        loop = []
        while True:
            left.remove(edge)
            loop.append(edge[0])
            ends = neighbours[edge[1]]
            edge = (edge[1], ends[ends.index(edge[0]) - 1])  # the next to the left
            if edge == start:
                break
        (outer if area(loop) > 0 else inner).append(loop)
    regions = [(loop, []) for loop in outer]
    for hole in inner:
        around = [region for region in regions if contains(region[0], hole[0]) and not set(hole) & set(region[0])]
        if around:
            min(around, key=lambda region: area(region[0]))[1].append(hole)
    return regions


def region_of(regions, point):
    """Index of the region that has the point inside it."""
    found = [i for i, (outer, holes) in enumerate(regions)
             if contains(outer, point) and not any(contains(hole, point) for hole in holes)]
    assert len(found) == 1, f"{point} is in {len(found)} regions"
    return found[0]
