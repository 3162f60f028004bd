"""Where the inputs of shader nodes come from."""


def upstream(node):
    """The nodes that a node's inputs come from, however far away."""
    found, todo = [], [node]
    while todo:
        for socket in todo.pop().inputs:
            for link in socket.links:
                if link.from_node not in found:
                    found.append(link.from_node)
                    todo.append(link.from_node)
    return found


def source(socket):
    """The node that a socket is linked to, past reroutes; None without one."""
    while socket.links and socket.links[0].from_node.type == "REROUTE":
        socket = socket.links[0].from_node.inputs[0]
    return socket.links[0].from_node if socket.links else None
