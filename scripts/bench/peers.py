"""Times numpy's and scipy's own solvers on the bench's formations; prints JSON, milliseconds, one entry a run."""

import json
import time

import numpy
from scipy.optimize import linear_sum_assignment
from scipy.spatial import Delaunay
from scipy.spatial.distance import cdist


def strewn(agent_count, seed):
    state, values = seed, []
    for _ in range(2 * agent_count):
        state = (state * 1664525 + 1013904223) & 0xFFFFFFFF
        values.append(state / 0xFFFFFFFF)
    return numpy.array(values).reshape(-1, 2) * numpy.sqrt(agent_count)


def laplacian(points):
    count = len(points)
    matrix = numpy.zeros((count, count))
    for triangle in Delaunay(points).simplices:
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = triangle[a], triangle[b]
            matrix[i, j] = matrix[j, i] = -1 / numpy.linalg.norm(points[i] - points[j])
    return matrix - numpy.diag(matrix.sum(axis=1))


def runs(count, work):
    work()
    times = []
    for _ in range(count):
        start = time.perf_counter()
        work()
        times.append((time.perf_counter() - start) * 1000)
    return times


rows = {}
for agent_count, count in ((300, 15), (1260, 7)):
    matrix = laplacian(strewn(agent_count, 1))
    rows[f"eigenbasis {agent_count}"] = runs(count, lambda: numpy.linalg.eigh(matrix))
for agent_count in (1260, 1936):
    source, target = strewn(agent_count, 1), strewn(agent_count, 2)
    rows[f"assignment {agent_count}"] = runs(7, lambda: linear_sum_assignment(cdist(source, target, "sqeuclidean")))
print(json.dumps(rows))
