"""Do one task of a run: a function of its arguments alone, so that it may run anywhere and be repeated."""

import json
import random

from exactmesh.io.pslg_json import pslg_from_json
from exactmesh.search.collect import Collector, Json
from exactmesh.search.corners import images
from exactmesh.search.families import family_of, planar_sample
from exactmesh.search.figure import Figure
from exactmesh.search.guided import guide
from exactmesh.search.lattice import lattice_polygons
from exactmesh.search.moves import climb
from exactmesh.search.spec import Spec, lattice_range, prefix_groups

_WARMTH = 0.2


def run_task(spec_text: str, key: str, payload: str = "") -> Json:
    """Return the report of the task `key` of the run that `spec_text` describes."""
    spec = Spec.from_json(spec_text)
    collector = Collector(spec.target_records())
    source = random.Random(f"{spec.seed} {spec.family} {key}")
    if spec.strategy == "exhaustive":
        _exhaust(spec, key, collector)
    elif spec.strategy == "inputs":
        for text in json.loads(payload):
            pslg = pslg_from_json(text)
            collector.see_input(pslg, Figure.of(pslg))
    elif spec.strategy == "guided":
        guide(collector.see, spec.size, source.getrandbits(64))
    else:
        _sample(spec, source, collector)
    return collector.result(key, spec.shrinks, spec.strategy != "inputs")


def _exhaust(spec: Spec, key: str, collector: Collector) -> None:
    """Judge all polygons of some prefixes, each in all different positions unless one is enough."""
    _, m, k, straight, all_images = lattice_range(spec)
    n, index = map(int, key.split(":"))
    for prefix in prefix_groups(m, k)[index]:
        for polygon in lattice_polygons(n, m, prefix, straight, k):
            for image in sorted(set(images(polygon))) if all_images else [polygon]:
                collector.see(Figure.polygon(image))


def _sample(spec: Spec, source: random.Random, collector: Collector) -> None:
    """Judge random figures, or walk from one."""
    family = family_of(spec.family, dict(spec.parameters), spec.plugin)
    if spec.strategy == "random":
        for _ in range(spec.size):
            if (figure := planar_sample(family, source)) is not None:
                collector.see(figure)
    elif (start := planar_sample(family, source)) is not None:
        climb(start, collector.see, spec.size, source, _WARMTH if spec.strategy == "anneal" else 0.0)
