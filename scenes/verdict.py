"""What commands that hold pictures against bounds share."""
import scene_files as files


def at_truth_size(name, *more):
    """Render a scene at the truth's size; more: options of scenes/render. Returns what render.render returns."""
    from render import parse, render

    return render(parse([name, "--percent", str(files.TRUTH_PERCENT), *more]))


def figures_of(name, result):
    """The figures of compare.py of a render of at_truth_size()."""
    from compare import compare, load

    return compare(load(str(files.check_truth(name))), load(result["exr"]))


def verdict(met):
    return "met" if met else "MISSED"
