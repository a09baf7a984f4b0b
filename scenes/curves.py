"""Error over cost of a method that was run from rough to fine."""
import numpy as np

ERRORS = 3  # at how many two curves are compared


def curve(points):
    """(error, cost) of the renders that no cheaper one is as right as, the smallest error first."""
    best = []
    for cost, error in sorted(points):
        if not best or error < best[0][0]:
            best.insert(0, (error, cost))
    return best


def ratios(ours, others):
    """[(error, cost of `ours` over cost of `others`)] at errors between the ends that both curves have."""
    low, high = max(ours[0][0], others[0][0]), min(ours[-1][0], others[-1][0])
    if low > high:
        return []
    errors = np.unique(np.geomspace(low, high, ERRORS).round(4))
    logarithms = [np.interp(np.log(errors), *np.log(np.array(points).T)) for points in (ours, others)]
    return list(zip(errors, np.exp(logarithms[0] - logarithms[1])))
