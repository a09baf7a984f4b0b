"""Reading node trees: through reroutes, muted nodes and groups, down to constants.

`groups` is the chain of group nodes that a socket lies in, outermost first.
"""

from .blackbody import blackbody


def follow(socket, groups=()):
    """What drives an input socket: (node, its output socket, groups); or (None, socket, groups), where that socket's
    own value counts."""
    while True:
        link = next((link for link in socket.links if not link.is_muted), None)
        if link is None:
            return None, socket, groups
        node, output = link.from_node, link.from_socket
        if node.mute:
            inner = next((link.from_socket for link in node.internal_links if link.to_socket == output), None)
        elif node.type == "REROUTE":
            inner = node.inputs[0]
        elif node.type == "GROUP" and node.node_tree:
            inner = _same_socket(_group_output(node.node_tree), output)
            groups += (node,)
        elif node.type == "GROUP_INPUT" and groups:
            inner = _same_socket(groups[-1].inputs, output)
            groups = groups[:-1]
        else:
            return node, output, groups
        if inner is None:
            return None, socket, groups
        socket = inner


def _group_output(tree):
    outputs = [node for node in tree.nodes if node.type == "GROUP_OUTPUT"]
    active = next((node for node in outputs if node.is_active_output), None)
    return active.inputs if active else ()


def _same_socket(sockets, wanted):
    return next((socket for socket in sockets if socket.identifier == wanted.identifier), None)


def constant(socket, groups=()):
    """The float or (r, g, b) of an input socket that nothing varying drives, else None."""
    node, output, groups = follow(socket, groups)
    if node is None or node.type in {"RGB", "VALUE"}:
        return plain(output.default_value) if hasattr(output, "default_value") else None
    if node.type == "BLACKBODY":
        kelvin = constant(node.inputs["Temperature"], groups)
        return None if kelvin is None else blackbody(as_float(kelvin))
    return None


def plain(value):
    """A socket's value as a float or a tuple of three."""
    return float(value) if isinstance(value, (int, float)) else tuple(value)[:3]


def as_color(value) -> tuple[float, float, float]:
    return (value,) * 3 if isinstance(value, float) else value


def as_float(value) -> float:
    """Of a colour: its luminance, as Blender's sockets convert it."""
    return value if isinstance(value, float) else 0.2126 * value[0] + 0.7152 * value[1] + 0.0722 * value[2]
