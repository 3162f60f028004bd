"""Follows the links of shader nodes."""


def upstream(node):
    """Returns all nodes on which the inputs of a node depend, directly or indirectly."""
    found, todo = [], [node]
    while todo:
        for socket in todo.pop().inputs:
            for link in socket.links:
                if link.from_node not in found:
                    found.append(link.from_node)
                    todo.append(link.from_node)
    return found


def source(socket):
    """Returns the node whose output is linked to an input socket, or None. Skips reroute nodes."""
    while socket.links and socket.links[0].from_node.type == "REROUTE":
        socket = socket.links[0].from_node.inputs[0]
    return socket.links[0].from_node if socket.links else None
